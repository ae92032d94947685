package simgsm.center.msc;

import java.time.Duration;
import simgsm.air.RadioResource;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The radio connection of one link (TS 44.018, 3.4): at most one at a time, opened by the mobile with its first message,
 * ended by CHANNEL RELEASE as soon as nothing needs it.
 */
final class NetworkRadioConnection {
    private enum State {
        IDLE,
        ESTABLISHED,
        /** CHANNEL RELEASE is sent; whatever still comes up was sent before the mobile saw it. */
        RELEASING
    }

    /** How long the mobile may take to leave the channel (T3109 of TS 44.018). */
    private static final long LEAVE_NANOS = Duration.ofSeconds(5).toNanos();
    /** How long the mobile may hold the channel after CM SERVICE ACCEPT without beginning what it asked for. */
    private static final long SERVICE_NANOS = Duration.ofSeconds(10).toNanos();

    private static final int NORMAL_RELEASE = 0;

    private final Link link;
    private final Timers timers;
    private State state = State.IDLE;
    private int expectedSequence;
    private Timer leaving;
    private Timer service;

    NetworkRadioConnection(Link link, Timers timers) {
        this.link = link;
        this.timers = timers;
    }

    boolean isEstablished() {
        return state == State.ESTABLISHED;
    }

    boolean isIdle() {
        return state == State.IDLE;
    }

    void established() {
        timers.cancel(leaving);
        state = State.ESTABLISHED;
        expectedSequence = 0;
    }

    /** Accepts N(SD) of an uplink message if it is the next one, else the message is a duplicate (TS 24.007, 11.2.3.2.3). */
    boolean acceptsSequence(int sequence) {
        if (sequence != expectedSequence) {
            return false;
        }
        expectedSequence ^= 1;
        return true;
    }

    /** The mobile may now open the transaction that it asked for. */
    void awaitService() {
        timers.cancel(service);
        service = timers.start(SERVICE_NANOS, () -> {
            service = null;
            link.touched();
        });
    }

    /** Whether a new mobile-originated transaction was granted; the grant holds for one. */
    boolean takeService() {
        boolean granted = service != null;
        timers.cancel(service);
        service = null;
        return granted;
    }

    /** Releases the channel if no transaction needs it any more. */
    void releaseIfUnused() {
        boolean used = link.registration != null
                || service != null
                || link.authenticity.isAwaited()
                || !link.callLegs.stream().allMatch(leg -> leg.state() == NetworkCallState.MM_CONNECTION_PENDING)
                || link.shortMessages.needRadio();
        if (state == State.ESTABLISHED && !used) {
            release();
        }
    }

    void release() {
        link.send(new RadioResource.ChannelRelease(NORMAL_RELEASE));
        takeService();
        state = State.RELEASING;
        leaving = timers.start(LEAVE_NANOS, this::left);
    }

    /** The mobile has left the channel. */
    void left() {
        timers.cancel(leaving);
        takeService();
        state = State.IDLE;
        link.paging.resume();
    }

    void close() {
        timers.cancel(leaving);
        takeService();
        state = State.IDLE;
    }
}
