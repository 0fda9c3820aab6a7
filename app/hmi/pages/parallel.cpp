// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page Parallel CNC: its Petri net is played.

#include "hmi/pages/pages.h"
#include "widgets/pipeline/net_panel.h"
#include "widgets/pipeline/parallel_page.h"

namespace rivulet::hmi {

using widgets::NetPanel;

QWidget* makeParallelPage(const Models& models, QWidget* parent) {
  auto* page = new widgets::ParallelPage(parent);
  NetPlayer* player = &models.player;
  NetPanel* net = page->net();
  const auto show = [net, player] { net->setState(player->state()); };
  QObject::connect(player, &NetPlayer::changed, net, show);
  QObject::connect(net, &NetPanel::choiceChanged, player, &NetPlayer::choose);
  QObject::connect(net, &NetPanel::stepRequested, player, &NetPlayer::step);
  QObject::connect(net, &NetPanel::playRequested, player, &NetPlayer::setPlaying);
  QObject::connect(net, &NetPanel::restartRequested, player, &NetPlayer::restart);
  QObject::connect(net, &NetPanel::speedChosen, player, &NetPlayer::setSpeed);
  show();
  return page;
}

}  // namespace rivulet::hmi
