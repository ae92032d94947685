package simgsm.cells.mobile;

import java.util.Optional;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioEvent;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.timer.Timers;

/** The measurements of one mobile every 480 ms: it moves, measures, and chooses a cell in idle mode or reports on its channel. */
final class MeasurementCycle {
    private final Mobile mobile;
    private final MobileNetwork network;
    private final Timers timers;
    private final Reception reception;
    private final CellNotice notice;
    private long measuredNanos;
    private boolean isStopped;

    /** Begins with the first measurement after a random part of the period. */
    MeasurementCycle(Mobile mobile, MobileNetwork network, Timers timers, Reception reception, CellNotice notice) {
        this.mobile = mobile;
        this.network = network;
        this.timers = timers;
        this.reception = reception;
        this.notice = notice;
        timers.start((long) (network.random() * Mobile.PERIOD_NANOS), this::period);
        measuredNanos = timers.nowNanos();
    }

    void stop() {
        isStopped = true;
    }

    private void period() {
        if (!isStopped) {
            timers.start(Mobile.PERIOD_NANOS, this::period);
            measure();
        }
    }

    void measure() {
        long now = timers.nowNanos();
        if (!network.isPaused()) {
            mobile.walker().advance(now - measuredNanos);
        }
        measuredNanos = now;
        reception.measure(mobile.walker().place());
        if (mobile.state() == MobileRadioState.DEDICATED) {
            mobile.link().measure();
            report();
            mobile.measured();
        } else if (mobile.channel().isEmpty() && mobile.isSwitchedOn()) {
            chooseCell(now);
        }
        tellCell();
    }

    private void tellCell() {
        int tower = mobile.serving();
        if (tower == IdleSelection.NONE) {
            notice.tell(Optional.empty(), 0);
        } else {
            notice.tell(network.towers().get(tower).cell(), reception.levelsDbm()[tower]);
        }
    }

    private void chooseCell(long now) {
        IdleSelection selection = mobile.selection();
        int before = selection.serving();
        CellParameters[] cells = network.towers().stream()
                .map(tower -> tower.isInService() ? CellParameters.of(tower) : null)
                .toArray(CellParameters[]::new);
        if (!selection.measured(now, reception.levelsDbm(), cells)) {
            return;
        }
        int chosen = selection.serving();
        if (chosen == IdleSelection.NONE) {
            network.happened(new MobileEvent.CellLost(mobile, network.nameOf(before)));
        } else {
            network.happened(new MobileEvent.Camped(mobile, network.nameOf(chosen), selection.c2(chosen)));
            mobile.camped();
        }
    }

    private void report() {
        if (mobile.link().report(mobile.current())) {
            network.happened(new MobileEvent.RadioLinkFailed(mobile));
            mobile.fire(MobileRadioEvent.LINK_FAILED);
        }
    }
}
