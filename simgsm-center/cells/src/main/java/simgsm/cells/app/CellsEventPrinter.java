package simgsm.cells.app;

import java.util.Locale;
import java.util.stream.Collectors;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.mobile.MobileRadioState;
import simgsm.cells.network.CellNetwork;
import simgsm.cells.radio.RadioScale;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.town.TownPlace;
import simgsm.console.Event;

/** Console events of the cells. */
final class CellsEventPrinter {
    private CellsEventPrinter() {}

    /** The event; null for one that only the window shows. */
    static Event of(MobileEvent event) {
        String number = event.mobile().number();
        if (event instanceof MobileEvent.Camped camped) {
            return Event.of("camped")
                    .with("number", number)
                    .with("cell", camped.cell())
                    .with("c2", decibels(camped.c2()));
        } else if (event instanceof MobileEvent.LocationUpdated updated) {
            return Event.of("location-update").with("number", number).with("lac", updated.area());
        } else if (event instanceof MobileEvent.Reported reported) {
            return Event.of("report")
                    .with("number", number)
                    .with("nr", reported.number())
                    .with("serving", reported.cell() + ":" + reported.level())
                    .with(
                            "neighbours",
                            reported.neighbours().stream()
                                    .map(each -> each.cell() + ":" + each.level())
                                    .collect(Collectors.joining(",")));
        } else if (event instanceof MobileEvent.HandedOver handover) {
            return Event.of("handover")
                    .with("number", number)
                    .with("from", handover.from())
                    .with("to", handover.to())
                    .with("result", handover.cause().isEmpty() ? "success" : "failure")
                    .with("cause", handover.cause().orElse(0));
        } else if (event instanceof MobileEvent.SpeechGap gap) {
            return Event.of("speech-gap").with("number", number).with("millis", gap.millis());
        } else if (event instanceof MobileEvent.RadioLinkFailed) {
            return Event.of("radio-link-failure").with("number", number);
        }
        return null;
    }

    static Event of(BaseStation tower) {
        TownPlace place = tower.tower().place();
        return Event.of("cell")
                .with("name", tower.tower().name())
                .with("arfcn", tower.tower().arfcn())
                .with("bsic", tower.tower().bsic())
                .with("lac", tower.area())
                .with("x", metres(place.xMetres()))
                .with("y", metres(place.yMetres()))
                .with("state", !tower.isOn() ? "off" : tower.isInService() ? "on" : "searching")
                .with("free", tower.freeTrafficChannels());
    }

    static Event of(Mobile mobile, CellNetwork network) {
        TownPlace place = mobile.walker().place();
        int tower = mobile.serving();
        double[] levels = new double[network.towers().size()];
        network.levelsDbm(place, levels);
        return Event.of("mobile")
                .with("number", mobile.number())
                .with("x", metres(place.xMetres()))
                .with("y", metres(place.yMetres()))
                .with("cell", mobile.cell())
                .with("rxlev", tower < 0 ? 0 : RadioScale.rxlev(levels[tower]))
                .with("state", mobile.state() == MobileRadioState.IDLE ? "idle" : "dedicated");
    }

    private static String metres(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    private static String decibels(double value) {
        return Long.toString(Math.round(value));
    }
}
