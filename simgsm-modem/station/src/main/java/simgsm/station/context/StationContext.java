package simgsm.station.context;

import java.util.function.Consumer;

/** The objects shared by all machines of one station. */
public record StationContext(
        StationIdentity identity,
        StationLog log,
        StationTimers timers,
        MobileRadioConnection radio,
        PendingEvents events) {

    /** @param settle runs after each timer that expires */
    public static StationContext of(StationIdentity identity, Consumer<StationEvent> listener, Runnable settle) {
        StationLog log = new StationLog(identity);
        PendingEvents events = new PendingEvents(listener, log);
        return new StationContext(
                identity, log, new StationTimers(settle), new MobileRadioConnection(log, events), events);
    }
}
