package simgsm.center.msc.link;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.timer.Timer;

/**
 * The radio connection of one link (TS 44.018, 3.4): at most one at a time, opened by the mobile with its first message,
 * released by the network when no transaction needs it.
 */
public final class NetworkRadioConnection {
    private enum State {
        IDLE,
        ESTABLISHED,
        /** CHANNEL RELEASE is sent; uplink messages are ignored until the mobile has left. */
        RELEASING
    }

    private final Link link;
    private State state = State.IDLE;
    private int expectedSequence;
    private long usedNanos;
    private Timer leaving;
    /** Runs while a mobile-originated transaction is granted and not yet begun. */
    private Timer service;

    private Optional<Msisdn> emergencyCaller = Optional.empty();

    NetworkRadioConnection(Link link) {
        this.link = link;
    }

    public boolean isEstablished() {
        return state == State.ESTABLISHED;
    }

    public boolean isIdle() {
        return state == State.IDLE;
    }

    /** Time of the connection's last opening or end. */
    public long usedNanos() {
        return usedNanos;
    }

    /** The mobile has opened the connection. */
    public void established() {
        link.timers().cancel(leaving);
        usedNanos = link.timers().nowNanos();
        state = State.ESTABLISHED;
        emergencyCaller = Optional.empty();
        expectedSequence = 0;
    }

    /** Continues the connection of another link, proved to be this one's mobile. */
    void takeOver(NetworkRadioConnection other) {
        established();
        expectedSequence = other.expectedSequence;
    }

    /** Accepts the N(SD) of an uplink message; false for a duplicate (TS 24.007, 11.2.3.2.3). */
    public boolean acceptsSequence(int sequence) {
        if (sequence != expectedSequence) {
            return false;
        }
        expectedSequence ^= 1;
        return true;
    }

    /** Grants an emergency call. @param caller shown to its receiver if the mobile is not registered */
    public void awaitEmergencyCall(Msisdn caller) {
        emergencyCaller = Optional.of(caller);
        awaitService();
    }

    /** The caller's number if an emergency call was granted on this connection. */
    public Optional<Msisdn> emergencyCaller() {
        return emergencyCaller;
    }

    /** Grants one mobile-originated transaction. */
    public void awaitService() {
        link.timers().cancel(service);
        service = link.timers().start(NetworkTimer.SERVICE.nanos(), () -> {
            service = null;
            link.touch();
        });
    }

    /** Ends the grant; false if there was none. */
    public boolean takeService() {
        boolean granted = service != null;
        link.timers().cancel(service);
        service = null;
        return granted;
    }

    /** True if a location update reserves the connection. */
    boolean isReserved() {
        return link.users().stream().anyMatch(user -> user.reservesRadio(link));
    }

    /** Releases the channel if no transaction needs it. */
    public void releaseIfUnused() {
        if (state == State.ESTABLISHED
                && service == null
                && link.users().stream().noneMatch(user -> user.needsRadio(link))) {
            release();
        }
    }

    public void release() {
        link.access().release();
        takeService();
        state = State.RELEASING;
        leaving = link.timers().start(NetworkTimer.T3109.nanos(), this::left);
    }

    /** The mobile has left the channel. */
    public void left() {
        close();
        link.paging().resume();
    }

    void close() {
        if (state != State.IDLE) {
            usedNanos = link.timers().nowNanos();
        }
        link.timers().cancel(leaving);
        takeService();
        state = State.IDLE;
    }
}
