package simgsm.center.msc.call;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;

/** A call from SETUP to its clearing: passes the events of one leg on to the other. */
public final class NetworkCall {
    private final CallSwitch exchange;
    private final long id;
    private final Msisdn from;
    private final Optional<Msisdn> to;
    private final CallLeg originating;
    private CallLeg terminating;
    /** The called link while this call is held; null otherwise. */
    private LinkCalls heldFor;

    private CallProgress state = CallProgress.INITIATED;
    private Optional<Cause> cause = Optional.empty();
    private long activeSinceNanos;
    private long endedActiveSeconds;

    NetworkCall(CallSwitch exchange, LinkCalls caller, TransactionIdentifier transaction, Optional<Msisdn> to) {
        this.exchange = exchange;
        this.id = exchange.nextCallId();
        this.from = caller.link().subscriber().number();
        this.to = to;
        this.originating = new CallLeg(this, caller, transaction, Optional.empty(), exchange.tones());
    }

    /** Unique, rising from 1 in the order of SETUP. */
    public long id() {
        return id;
    }

    /** Why the call was cleared; empty before. */
    public Optional<Cause> cause() {
        return cause;
    }

    public Msisdn from() {
        return from;
    }

    /** The number as dialled; empty if it could not be decoded. */
    public Optional<Msisdn> to() {
        return to;
    }

    public CallProgress state() {
        return state;
    }

    /** Since the call became active; 0 before, and after its end the whole time. */
    long activeSeconds() {
        return state == CallProgress.ACTIVE
                ? TimeUnit.NANOSECONDS.toSeconds(nowNanos() - activeSinceNanos)
                : endedActiveSeconds;
    }

    private long nowNanos() {
        return originating.link().timers().nowNanos();
    }

    CallLeg originating() {
        return originating;
    }

    /** Null until the called mobile is paged. */
    CallLeg terminating() {
        return terminating;
    }

    /** Holds the call until the called link has cleared its last one. */
    void hold(LinkCalls called) {
        heldFor = called;
        called.hold(this);
    }

    /** Calls the mobile on this link. */
    void extend(LinkCalls called, TransactionIdentifier transaction) {
        originating.proceed();
        terminating = new CallLeg(this, called, transaction, Optional.of(from), Optional.empty());
        terminating.page();
    }

    /** Ends a call that cannot be connected. */
    void refuse(Cause cause) {
        end(originating, cause);
    }

    private CallLeg other(CallLeg leg) {
        return leg == originating ? terminating : originating;
    }

    /** The leg that hears this one; null if none does. */
    CallLeg listenerOf(CallLeg leg) {
        CallLeg other = other(leg);
        return other != null && other.state().speaks() ? other : null;
    }

    void offered() {
        enter(CallProgress.INITIATED);
        exchange.route(this);
    }

    void alerting() {
        enter(CallProgress.ALERTING);
        originating.alert();
    }

    void answered() {
        originating.answer();
    }

    void active() {
        activeSinceNanos = nowNanos();
        enter(CallProgress.ACTIVE);
    }

    /** A leg is being cleared by its mobile, a timer or the loss of its link. */
    void cleared(CallLeg leg, Cause cause) {
        end(other(leg), cause);
    }

    private void end(CallLeg rest, Cause why) {
        if (state != CallProgress.RELEASED) {
            cause = Optional.of(why);
            endedActiveSeconds = activeSeconds();
            if (heldFor != null) {
                heldFor.forget(this);
            }
            enter(CallProgress.RELEASED);
            if (rest != null) {
                rest.clear(why);
            }
        }
    }

    private void enter(CallProgress next) {
        state = next;
        exchange.changed(this);
    }
}
