package simgsm.center.msc;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.timer.Timers;

/** A call from its first SETUP to its clearing: what happens on one leg, told to the other. */
final class NetworkCall implements CallLeg.Owner {
    private final CallSwitch exchange;
    private final Msisdn from;
    private final Optional<Msisdn> to;
    private final CallLeg originating;
    private final Timers timers;
    private CallLeg terminating;
    private CallProgress state = CallProgress.INITIATED;
    /** Of meaning once the call is active. */
    private long activeSinceNanos;

    NetworkCall(CallSwitch exchange, Link link, TransactionIdentifier transaction, Optional<Msisdn> to, Timers timers) {
        this.exchange = exchange;
        this.from = link.subscriber.number();
        this.to = to;
        this.timers = timers;
        this.originating = new CallLeg(link, transaction, Optional.empty(), exchange.tones(), link.timers, this);
    }

    Msisdn from() {
        return from;
    }

    /** The number as dialled; empty if there was none to be read. */
    Optional<Msisdn> to() {
        return to;
    }

    CallProgress state() {
        return state;
    }

    long activeSeconds() {
        return state == CallProgress.ACTIVE ? TimeUnit.NANOSECONDS.toSeconds(timers.nowNanos() - activeSinceNanos) : 0;
    }

    CallLeg originating() {
        return originating;
    }

    /** Null until the called mobile is looked for. */
    CallLeg terminating() {
        return terminating;
    }

    /** The called mobile is known and free: go and fetch it. */
    void extend(Link called, TransactionIdentifier transaction) {
        originating.proceed();
        terminating = new CallLeg(called, transaction, Optional.of(from), Optional.empty(), called.timers, this);
        terminating.page();
    }

    /** The call cannot be put through. */
    void refuse(Cause cause) {
        end(originating, cause);
    }

    @Override
    public CallLeg listenerOf(CallLeg leg) {
        CallLeg other = leg == originating ? terminating : originating;
        return other != null && other.state().speaks() ? other : null;
    }

    @Override
    public void offered(CallLeg leg) {
        enter(CallProgress.INITIATED);
        exchange.route(this);
    }

    @Override
    public void alerting(CallLeg leg) {
        enter(CallProgress.ALERTING);
        originating.alert();
    }

    @Override
    public void answered(CallLeg leg) {
        originating.answer();
    }

    @Override
    public void active(CallLeg leg) {
        activeSinceNanos = timers.nowNanos();
        enter(CallProgress.ACTIVE);
    }

    @Override
    public void cleared(CallLeg leg, Cause cause) {
        end(leg == originating ? terminating : originating, cause);
    }

    private void end(CallLeg rest, Cause cause) {
        if (state != CallProgress.RELEASED) {
            enter(CallProgress.RELEASED);
            if (rest != null) {
                rest.clear(cause);
            }
        }
    }

    private void enter(CallProgress next) {
        state = next;
        exchange.changed(this);
    }
}
