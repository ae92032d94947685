package simgsm.center.bsc;

import java.util.Optional;
import simgsm.center.bsc.handover.HandoverDecision;
import simgsm.center.bsc.handover.Measurement;
import simgsm.center.bsc.handover.NeighbourCell;

/** Finds a free traffic channel in another cell for a mobile's handover. */
final class HandoverTarget {
    /** Minimum RXLEV of a neighbour for a directed retry: -90 dBm. */
    private static final int DIRECTED_RETRY_LEVEL = 20;

    private final BaseStationController controller;

    HandoverTarget(BaseStationController controller) {
        this.controller = controller;
    }

    /**
     * The decision's target.
     *
     * @param decision has been given the latest measurement; null on a signalling channel
     */
    Optional<DedicatedChannel> better(DedicatedChannel channel, HandoverDecision decision) {
        return decision == null || !channel.carriesSpeech()
                ? Optional.empty()
                : decision.target().flatMap(wanted -> free(wanted.cell(), channel));
    }

    /** Directed retry: a traffic channel in the strongest neighbour for a waiting call. */
    Optional<DedicatedChannel> elsewhere(DedicatedChannel channel, Measurement measurement) {
        return measurement.neighbours().stream()
                .filter(each -> each.level() >= DIRECTED_RETRY_LEVEL)
                .sorted((one, other) -> Integer.compare(other.level(), one.level()))
                .flatMap(each -> free(each.cell(), channel).stream())
                .findFirst();
    }

    private Optional<DedicatedChannel> free(NeighbourCell cell, DedicatedChannel channel) {
        return controller
                .tower(cell)
                .filter(tower -> tower != channel.tower())
                .flatMap(TowerControl::freeTrafficChannel);
    }
}
