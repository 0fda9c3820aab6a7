# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""deploy/kubernetes against the schema of Kubernetes, and against itself.

The schema is that of Debian's client library, which is generated from the OpenAPI description of Kubernetes:
names of fields, their types, which must be there, and which values are allowed.
"""

import pathlib
import re

import pytest

client = pytest.importorskip("kubernetes.client")
yaml = pytest.importorskip("yaml")

FOLDER = pathlib.Path(__file__).parents[2] / "deploy" / "kubernetes"
PATHS = sorted(FOLDER.glob("*.yaml"))
MODELS = {("v1", "PersistentVolumeClaim"): "V1PersistentVolumeClaim", ("v1", "ConfigMap"): "V1ConfigMap",
          ("v1", "Service"): "V1Service", ("apps/v1", "Deployment"): "V1Deployment",
          ("batch/v1", "Job"): "V1Job"}  # fmt: skip
SIMPLE = {"str": str, "int": int, "bool": bool, "float": (int, float)}
# What the schema calls an object and Kubernetes parses from a text or a number.
QUANTITY = re.compile(r"[0-9.]+(m|[kMGTPE]i?)?")


def check(value, kind, where):
    """Raises ValueError with the place of what `kind` does not allow."""
    if match := re.fullmatch(r"list\[(.*)\]", kind):
        if not isinstance(value, list):
            raise ValueError(f"{where}: a list is needed")
        for number, entry in enumerate(value):
            check(entry, match[1], f"{where}[{number}]")
    elif match := re.fullmatch(r"dict\(str, (.*)\)", kind):
        for key, entry in value.items():
            check(entry, match[1], f"{where}.{key}")
            if where.endswith((".requests", ".limits")) and not QUANTITY.fullmatch(str(entry)):
                raise ValueError(f"{where}.{key}: {entry} is no quantity")
    elif kind in SIMPLE:
        if not isinstance(value, SIMPLE[kind]) or (kind != "bool" and isinstance(value, bool)):
            raise ValueError(f"{where}: {value!r} is no {kind}")
    elif kind != "object":
        model = getattr(client, kind)
        fields = {name: field for field, name in model.attribute_map.items()}
        arguments = {}
        for name, entry in value.items():
            if name not in fields:
                raise ValueError(f"{where}: {kind} has no field {name}")
            check(entry, model.openapi_types[fields[name]], f"{where}.{name}")
            arguments[fields[name]] = entry
        model(**arguments)  # what must be there, and what its values may be


def documents(text):
    return [document for document in yaml.safe_load_all(text) if document is not None]


def check_document(document):
    kind = (document.get("apiVersion"), document.get("kind"))
    if kind not in MODELS:
        raise ValueError(f"{kind} is not known")
    check(document, MODELS[kind], document["kind"])


def pod_of(document):
    return document["spec"]["template"]["spec"]


def check_names(all_documents):
    """What one part of a file calls by name, another part has."""
    claims = {d["metadata"]["name"] for d in all_documents if d["kind"] == "PersistentVolumeClaim"}
    maps = {d["metadata"]["name"] for d in all_documents if d["kind"] == "ConfigMap"}
    with_pods = [d for d in all_documents if d["kind"] in ("Deployment", "Job")]
    for document in with_pods:
        volumes = {volume["name"] for volume in pod_of(document).get("volumes", [])}
        for volume in pod_of(document).get("volumes", []):
            claim = volume.get("persistentVolumeClaim", {}).get("claimName")
            config = volume.get("configMap", {})
            if claim not in claims | {None}:
                raise ValueError(f"volume {volume['name']}: no claim {claim}")
            if config and not config.get("optional") and config["name"] not in maps:
                raise ValueError(f"volume {volume['name']}: no map {config['name']}")
        for container in pod_of(document)["containers"]:
            ports = {port["name"] for port in container.get("ports", [])}
            for mount in container.get("volumeMounts", []):
                if mount["name"] not in volumes:
                    raise ValueError(f"{container['name']}: no volume {mount['name']}")
            for probe in ("startupProbe", "livenessProbe", "readinessProbe"):
                if probe in container and container[probe]["tcpSocket"]["port"] not in ports:
                    raise ValueError(f"{container['name']}: {probe} asks a port that is not there")
        if document["kind"] == "Deployment":
            labels = document["spec"]["template"]["metadata"]["labels"]
            if not document["spec"]["selector"]["matchLabels"].items() <= labels.items():
                raise ValueError("the selector does not choose its own pods")
    for service in (d for d in all_documents if d["kind"] == "Service"):
        chosen = [d for d in with_pods
                  if service["spec"]["selector"].items() <= d["spec"]["template"]["metadata"]["labels"].items()]  # fmt: skip
        ports = {port["name"] for d in chosen for c in pod_of(d)["containers"] for port in c.get("ports", [])}
        for port in service["spec"]["ports"]:
            if port["targetPort"] not in ports:
                raise ValueError(f"service: no pod has the port {port['targetPort']}")


def check_file(text):
    found = documents(text)
    for document in found:
        check_document(document)
    check_names(found)


@pytest.mark.parametrize("path", PATHS, ids=lambda path: path.name)
def test_manifest(path):
    check_file(path.read_text())


def test_all_are_looked_at():
    assert [path.name for path in PATHS] == ["machine.yaml", "pipeline-job.yaml", "sweep-job.yaml"]


WRONG = {
    "a field that is misspelt": ("readOnlyRootFilesystem", "readonlyRootFilesystem"),
    "a field in the wrong place": ("replicas: 1", "restartPolicy: Never"),
    "a text in place of a number": ("failureThreshold: 60", 'failureThreshold: "60"'),
    "a number in place of a text": ("--port=4841", "4841"),
    "a value that does not exist": ("apps/v1", "apps/v9"),
    "no selector": ("selector:\n    matchLabels: {app: rivulet, machine: mill3}\n  template", "template"),
    "a list without dashes": ("command: [/usr/bin/rivulet-service]", "command: /usr/bin/rivulet-service"),
    "no quantity": ("memory: 64Mi", "memory: 64 MB"),
    "another selector": ("matchLabels: {app: rivulet, machine: mill3}", "matchLabels: {app: other}"),
    "a volume that is not there": ("{name: state, mountPath", "{name: stat, mountPath"),
    "a claim that is not there": ("claimName: rivulet-mill3", "claimName: mill3"),
    "a probe of no port": ("tcpSocket: {port: opcua}\n            periodSeconds: 5", "tcpSocket: {port: page}"),
    "a service of no port": ("targetPort: opcua", "targetPort: page"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_manifest(name):
    text = (FOLDER / "machine.yaml").read_text()
    right, wrong = WRONG[name]
    assert right in text
    with pytest.raises(ValueError):
        check_file(text.replace(right, wrong, 1))
