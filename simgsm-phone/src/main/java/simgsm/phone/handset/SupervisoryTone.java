package simgsm.phone.handset;

import simgsm.air.Cause;

/**
 * What the phone itself plays to tell how a call goes (TS 22.001, annex F, European tones), and its own ring. In GSM
 * these sounds are not sent: the phone makes them from the network's messages.
 */
enum SupervisoryTone {
    NONE(0, 0, 0),
    /** The other phone rings: 425 Hz, 1 s on, 4 s off. */
    RINGING(1000, 4000, 60_000, 425),
    /** 425 Hz, 500 ms on and off. */
    BUSY(500, 500, 4_000, 425),
    /** 425 Hz, 200 ms on and off. */
    CONGESTION(200, 200, 3_000, 425),
    /** 950, 1400 and 1800 Hz one after the other, 330 ms each, 1 s off. */
    ERROR(990, 1000, 4_000, 950, 1400, 1800),
    /** 425 Hz, 200 ms on and off, for 1.2 s. */
    DROPPED(200, 200, 1_200, 425),
    /** Our own ring: a warble of 20 changes a second, 1 s on, 2 s off. */
    INCOMING(1000, 2000, 60_000, 880, 1175);

    private static final int WARBLE_MILLIS = 50;

    final int onMillis;
    final int offMillis;
    final int totalMillis;
    private final double[] hertz;

    SupervisoryTone(int onMillis, int offMillis, int totalMillis, double... hertz) {
        this.onMillis = onMillis;
        this.offMillis = offMillis;
        this.totalMillis = totalMillis;
        this.hertz = hertz;
    }

    /** What sounds at a moment of the cadence's time that is on. */
    double hertzAt(int millis) {
        int step = this == INCOMING ? WARBLE_MILLIS : onMillis / hertz.length;
        return hertz[millis / step % hertz.length];
    }

    /** What the user hears when a call ends for this cause. */
    static SupervisoryTone of(Cause cause) {
        return switch (cause) {
            case USER_BUSY -> BUSY;
            case NO_CIRCUIT_AVAILABLE, NETWORK_OUT_OF_ORDER, SWITCHING_EQUIPMENT_CONGESTION, RESOURCES_UNAVAILABLE ->
                CONGESTION;
            case TEMPORARY_FAILURE -> DROPPED;
            case UNASSIGNED_NUMBER, NUMBER_CHANGED, DESTINATION_OUT_OF_ORDER, INVALID_NUMBER_FORMAT -> ERROR;
            default -> NONE;
        };
    }
}
