package simgsm.center.msc.call;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.ss.NotifySs;
import simgsm.ss.SsCode;
import simgsm.timer.Timer;

/** A call from SETUP to its clearing: passes the events of each leg to the other. */
public final class NetworkCall {
    /** Limits circular forwarding. */
    private static final int MAX_FORWARDINGS = 5;

    private final CallSwitch exchange;
    private final long id;
    private final Msisdn from;
    private final Optional<Msisdn> to;
    /** True if the caller hides its number from the called mobile. */
    private final boolean isHidden;

    private final CallLeg originating;
    private CallLeg terminating;
    /** The called link while this call is held; null otherwise. */
    private LinkCalls heldFor;

    /** The current destination: the dialled number, or the last one of a forwarding. */
    private Optional<Msisdn> target;

    /** The subscriber who has forwarded the call last. */
    private Optional<Msisdn> redirecting = Optional.empty();

    private int forwardings;
    private boolean isAnswered;
    private Timer noReply;
    private CallProgress state = CallProgress.INITIATED;
    private Optional<Cause> cause = Optional.empty();
    private long activeSinceNanos;
    private long endedActiveSeconds;

    NetworkCall(
            CallSwitch exchange,
            LinkCalls caller,
            TransactionIdentifier transaction,
            Optional<Msisdn> to,
            boolean isHidden) {
        this.exchange = exchange;
        this.id = exchange.nextCallId();
        this.from = caller.link().hasSubscriber()
                ? caller.link().subscriber().number()
                : caller.link().radio().emergencyCaller().orElseThrow();
        this.to = to;
        this.isHidden = isHidden;
        this.target = to;
        this.originating = new CallLeg(this, caller, transaction, Optional.empty(), exchange.tones());
    }

    long setupNanos() {
        return exchange.setupNanos();
    }

    /** Unique, increasing from 1 in the order of SETUP. */
    public long id() {
        return id;
    }

    /** The cause of the clearing; empty before. */
    public Optional<Cause> cause() {
        return cause;
    }

    public Msisdn from() {
        return from;
    }

    /** The dialled number; empty if it could not be decoded. */
    public Optional<Msisdn> to() {
        return to;
    }

    public CallProgress state() {
        return state;
    }

    /** Seconds since the call became active; 0 before, constant after its end. */
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

    /** The subscriber who answers, possibly after forwarding; empty if the network does. */
    Optional<Msisdn> connected() {
        return Optional.ofNullable(terminating)
                .map(leg -> exchange.home().shown(leg.link().subscriber().number()));
    }

    /** Answers the call with a notice, in place of a subscriber. */
    void announce() {
        answered();
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

    /** The currently called number; empty if it could not be decoded. */
    Optional<Msisdn> target() {
        return target;
    }

    /**
     * Forwards the call to another number.
     *
     * @return false if it was forwarded too often (TS 22.082, 1.3)
     */
    boolean turn(Msisdn next) {
        if (forwardings == MAX_FORWARDINGS) {
            return false;
        }
        forwardings++;
        target = Optional.of(next);
        stopNoReply();
        return true;
    }

    /** As {@link #turn}, for a subscriber's forwarding, with a notification to the caller (TS 24.082). */
    boolean forward(Msisdn next, SsCode condition) {
        Optional<Msisdn> subscriber = target;
        if (!turn(next)) {
            return false;
        }
        redirecting = subscriber;
        originating.notify(NotifySs.OUTGOING_CALL_FORWARDED, condition);
        return true;
    }

    Optional<Msisdn> redirecting() {
        return redirecting.map(exchange.home()::shown);
    }

    private void stopNoReply() {
        originating.link().timers().cancel(noReply);
    }

    /** Calls the mobile on this link. */
    void extend(LinkCalls called, TransactionIdentifier transaction) {
        originating.proceed();
        terminating = new CallLeg(this, called, transaction, shownCaller(), Optional.empty());
        terminating.page();
    }

    private Optional<Msisdn> shownCaller() {
        boolean isSubscriber = originating.link().hasSubscriber();
        return isHidden
                ? Optional.empty()
                : Optional.of(isSubscriber ? exchange.home().shown(from) : from);
    }

    /** Ends a call that cannot be connected. */
    void refuse(Cause cause) {
        end(originating, cause, false);
    }

    private CallLeg other(CallLeg leg) {
        return leg == originating ? terminating : originating;
    }

    /** The leg that receives this one's speech; null if none does. */
    CallLeg listenerOf(CallLeg leg) {
        CallLeg other = other(leg);
        return other != null && other.speaks() && leg.speaks() ? other : null;
    }

    /** Handles hold and retrieval by a mobile; the held party hears a tone meanwhile. */
    void holdChanged(CallLeg leg) {
        CallLeg other = other(leg);
        if (other != null) {
            other.notifyHold(leg.isHeld());
            other.heldByOther(leg.isHeld() && !other.isHeld());
            leg.heldByOther(!leg.isHeld() && other.isHeld());
        }
    }

    void offered() {
        enter(CallProgress.INITIATED);
        exchange.route(this);
    }

    void alerting() {
        enter(CallProgress.ALERTING);
        originating.alert();
        if (exchange.forwarding(this, SsCode.FORWARDING_ON_NO_REPLY).isPresent()) {
            noReply = originating.link().timers().start(exchange.noReplyNanos(this), this::notAnswered);
        }
    }

    /** Leaves the called mobile, and continues the call with another one. */
    private void notAnswered() {
        CallLeg left = terminating;
        if (exchange.divert(this, SsCode.FORWARDING_ON_NO_REPLY)) {
            left.clear(Cause.NORMAL_CALL_CLEARING, false);
        }
    }

    void answered() {
        isAnswered = true;
        stopNoReply();
        originating.answer();
    }

    void active() {
        activeSinceNanos = nowNanos();
        enter(CallProgress.ACTIVE);
        if (terminating == null) {
            originating.playNotice();
            noReply = originating
                    .link()
                    .timers()
                    .start(NetworkTimer.NOTICE.nanos(), () -> refuse(Cause.NORMAL_CALL_CLEARING));
        }
    }

    /** Handles the clearing of a leg by its mobile, a timer or the loss of its link. */
    void cleared(CallLeg leg, Cause cause) {
        boolean isCalled = leg == terminating;
        boolean isForwarded = isCalled && !isAnswered && exchange.divert(this, cause);
        if (!isForwarded && (isCalled || leg == originating)) {
            end(other(leg), cause, leg.isClearedByUser());
        }
    }

    private void end(CallLeg rest, Cause why, boolean byUser) {
        if (state != CallProgress.RELEASED) {
            cause = Optional.of(why);
            stopNoReply();
            endedActiveSeconds = activeSeconds();
            if (heldFor != null) {
                heldFor.forget(this);
            }
            enter(CallProgress.RELEASED);
            if (rest != null) {
                rest.clear(why, byUser);
            }
        }
    }

    private void enter(CallProgress next) {
        state = next;
        exchange.changed(this);
    }
}
