package simgsm.center.msc;

import java.time.Duration;
import simgsm.air.Cause;

/** Call control timers of the network side (TS 24.008, table 11.4). */
enum NetworkCallTimer {
    /** The called mobile rings and nobody answers; "at least 3 minutes". */
    T301(180, NetworkCallEvent.T301_EXPIRED, Cause.USER_ALERTING_NO_ANSWER),
    /** SETUP is not answered. */
    T303(30, NetworkCallEvent.T303_EXPIRED, Cause.NO_USER_RESPONDING),
    /** DISCONNECT is not answered. */
    T305(30, NetworkCallEvent.T305_EXPIRED, Cause.RECOVERY_ON_TIMER_EXPIRY),
    /** DISCONNECT with a tone is not answered; the standard leaves its length to the network, at most 30 s here. */
    T306(30, NetworkCallEvent.T306_EXPIRED, Cause.RECOVERY_ON_TIMER_EXPIRY),
    /** RELEASE is not answered; repeated once. */
    T308(30, NetworkCallEvent.T308_EXPIRED, Cause.RECOVERY_ON_TIMER_EXPIRY),
    /** The called mobile has confirmed the call and does not go on. */
    T310(30, NetworkCallEvent.T310_EXPIRED, Cause.NO_USER_RESPONDING),
    /** The caller does not acknowledge CONNECT. */
    T313(30, NetworkCallEvent.T313_EXPIRED, Cause.RECOVERY_ON_TIMER_EXPIRY);

    private final Duration duration;
    private final NetworkCallEvent expiry;
    private final Cause toldCause;

    NetworkCallTimer(int seconds, NetworkCallEvent expiry, Cause toldCause) {
        this.duration = Duration.ofSeconds(seconds);
        this.expiry = expiry;
        this.toldCause = toldCause;
    }

    long nanos() {
        return duration.toNanos();
    }

    NetworkCallEvent expiry() {
        return expiry;
    }

    /** What the other party of the call is told. */
    Cause toldCause() {
        return toldCause;
    }
}
