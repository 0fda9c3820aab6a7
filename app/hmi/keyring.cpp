// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/keyring.h"

#ifdef RIVULET_WITH_KEYRING
#include <qt6keychain/keychain.h>
#endif

namespace rivulet::hmi {

namespace {

#ifdef RIVULET_WITH_KEYRING

class SystemKeyring final : public Keyring {
 public:
  void read(const QString& key, std::function<void(Outcome, const QString&)> answer) override {
    auto* job = new QKeychain::ReadPasswordJob(service());
    start(job, key, [job, answer = std::move(answer)] {
      answer(outcomeOf(*job), job->error() == QKeychain::NoError ? job->textData() : QString());
    });
  }

  void write(const QString& key, const QString& password,
             std::function<void(Outcome)> answer) override {
    auto* job = new QKeychain::WritePasswordJob(service());
    job->setTextData(password);
    start(job, key, [job, answer = std::move(answer)] { answer(outcomeOf(*job)); });
  }

  void remove(const QString& key, std::function<void(Outcome)> answer) override {
    auto* job = new QKeychain::DeletePasswordJob(service());
    start(job, key, [job, answer = std::move(answer)] { answer(outcomeOf(*job)); });
  }

 private:
  static QString service() { return QStringLiteral("Rivulet"); }

  static Outcome outcomeOf(const QKeychain::Job& job) {
    switch (job.error()) {
      case QKeychain::NoError:
        return Outcome::Done;
      case QKeychain::EntryNotFound:
        return Outcome::NotKept;
      case QKeychain::AccessDenied:
      case QKeychain::AccessDeniedByUser:
      case QKeychain::CouldNotDeleteEntry:
        return Outcome::Refused;
      case QKeychain::NoBackendAvailable:
      case QKeychain::NotImplemented:
      case QKeychain::OtherError:
        break;
    }
    return Outcome::Missing;
  }

  template <class Finish>
  static void start(QKeychain::Job* job, const QString& key, Finish finish) {
    job->setKey(key);
    job->setInsecureFallback(false);  // never in plain text
    QObject::connect(job, &QKeychain::Job::finished, job, finish);
    job->start();  // deletes itself
  }
};

#else

class SystemKeyring final : public Keyring {
 public:
  void read(const QString&, std::function<void(Outcome, const QString&)> answer) override {
    answer(Outcome::Missing, {});
  }
  void write(const QString&, const QString&, std::function<void(Outcome)> answer) override {
    answer(Outcome::Missing);
  }
  void remove(const QString&, std::function<void(Outcome)> answer) override {
    answer(Outcome::Missing);
  }
};

#endif

}  // namespace

std::unique_ptr<Keyring> systemKeyring() {
  return std::make_unique<SystemKeyring>();
}

}  // namespace rivulet::hmi
