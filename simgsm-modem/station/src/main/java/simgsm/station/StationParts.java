package simgsm.station;

/** What all machines of one station share. */
record StationParts(
        StationIdentity identity,
        StationLog log,
        StationTimers timers,
        MobileRadioConnection radio,
        Notifications notifications) {

    StationParts(StationIdentity identity, StationListener listener) {
        this(identity, new StationLog(identity), listener);
    }

    private StationParts(StationIdentity identity, StationLog log, StationListener listener) {
        this(identity, log, new StationTimers(), new MobileRadioConnection(log), new Notifications(listener, log));
    }
}
