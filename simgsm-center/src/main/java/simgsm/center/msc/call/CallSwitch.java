package simgsm.center.msc.call;

import java.lang.System.Logger.Level;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.CauseLocation;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkUser;
import simgsm.center.msc.mobility.MobilityProcedures;
import simgsm.center.subscriber.HomeRegister;
import simgsm.center.subscriber.Subscriber;
import simgsm.ss.NotifySs;
import simgsm.ss.SsCode;
import simgsm.tone.ToneSet;

/** Number analysis and switching: connects the two legs of each call, and the speech between them. */
public final class CallSwitch implements LinkUser {
    /** Maximum of simultaneous calls; further ones are refused with cause 42. */
    static final int MAX_CALLS = 5_000;

    private static final System.Logger LOG = System.getLogger(CallSwitch.class.getName());
    /** The number of an emergency call, whose setup has none. */
    private static final Msisdn EMERGENCY = new Msisdn("112");

    /** RTP version 2 in bits 8-7 of the first octet (RFC 3550, 5.1). */
    private static final int RTP_VERSION_MASK = 0xc0;

    private static final int RTP_VERSION_2 = 0x80;
    private static final int RTP_HEADER_LENGTH = 12;

    private final MobilityProcedures mobility;
    private final Consumer<NetworkCall> changes;
    private final boolean callWaiting;
    private final long setupNanos;
    private final Set<NetworkCall> calls = new LinkedHashSet<>();
    private final Map<Link, LinkCalls> links = new HashMap<>();
    private final Optional<ToneSet> tones;
    private Optional<Msisdn> emergencyNumber = Optional.empty();
    private final KeyTap keyTap = new KeyTap();
    private long lastCallId;
    private long speechFramesSwitched;

    /**
     * @param tones of the network to callers, if any
     * @param callWaiting default of offering a second call to a mobile in a call
     * @param setupNanos T303
     * @param changes receives each call that enters a state
     */
    public CallSwitch(
            MobilityProcedures mobility,
            Optional<ToneSet> tones,
            boolean callWaiting,
            long setupNanos,
            Consumer<NetworkCall> changes) {
        this.setupNanos = setupNanos;
        this.tones = tones;
        this.mobility = mobility;
        this.changes = changes;
        this.callWaiting = callWaiting;
    }

    /** Sets who answers emergency calls; empty for a notice. */
    public void setEmergencyNumber(Optional<Msisdn> number) {
        emergencyNumber = number;
    }

    /** Calls from SETUP to the first clearing message, oldest first. */
    public Collection<NetworkCall> calls() {
        return Collections.unmodifiableSet(calls);
    }

    Optional<ToneSet> tones() {
        return tones;
    }

    long setupNanos() {
        return setupNanos;
    }

    public KeyTap keyTap() {
        return keyTap;
    }

    public long speechFramesSwitched() {
        return speechFramesSwitched;
    }

    private LinkCalls on(Link link) {
        return links.computeIfAbsent(link, LinkCalls::new);
    }

    /** The leg of a transaction as written by the mobile. */
    public Optional<CallLeg> leg(Link link, TransactionIdentifier received) {
        return on(link).leg(received);
    }

    @Override
    public boolean needsRadio(Link link) {
        return on(link).needsRadio();
    }

    @Override
    public void radioLost(Link link) {
        on(link).radioLost();
    }

    @Override
    public void linkClosed(Link link) {
        LinkCalls closed = on(link);
        links.remove(link);
        closed.releaseHeld(this::reach);
    }

    /** Passes a message to its leg; without one it is answered by TS 24.008, 8.3. */
    public void receive(Link link, CallControl message) {
        Optional<CallLeg> leg = leg(link, message.transaction());
        boolean isEmergency = message instanceof CallControl.EmergencySetup;
        if (isEmergency || message instanceof CallControl.Setup) {
            if (leg.isEmpty() && !message.transaction().fromOtherSide()) {
                open(link, message);
            }
        } else if (leg.isPresent()) {
            leg.get().receive(message);
        } else if (needsAnswer(message)) {
            refuse(link, message.transaction(), Cause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private static boolean needsAnswer(CallControl message) {
        return !(message instanceof CallControl.ReleaseComplete)
                && !(message instanceof CallControl.Status status && status.callState() == 0);
    }

    private static void refuse(Link link, TransactionIdentifier transaction, Cause cause) {
        link.send(new CallControl.ReleaseComplete(
                transaction.answered(), Optional.of(cause), Optional.of(CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER)));
    }

    private void open(Link link, CallControl setup) {
        Optional<Msisdn> called = setup instanceof CallControl.Setup normal
                ? normal.called().map(home()::called)
                : Optional.of(EMERGENCY);
        boolean isEmergency = setup instanceof CallControl.EmergencySetup;
        if (link.radio().takeService() && (isEmergency || link.hasSubscriber())) {
            boolean isHidden = setup instanceof CallControl.Setup normal && normal.hidesNumber();
            NetworkCall call =
                    new NetworkCall(this, on(link), setup.transaction().answered(), called, isHidden);
            if (isEmergency) {
                LOG.log(
                        Level.WARNING,
                        "{0}: emergency call, {1}",
                        call.from(),
                        emergencyNumber
                                .map(number -> "to " + number)
                                .orElse("answered by a notice, because --emergency names no number"));
            }
            call.originating().receive(setup);
        } else {
            refuse(link, setup.transaction(), Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    /** Connects a call to the called mobile, or refuses it. */
    void route(NetworkCall call) {
        boolean isEmergency = call.to().filter(Msisdn::isEmergency).isPresent();
        if (tones.isPresent() || isEmergency) {
            // a tone for a refused call first needs a channel (TS 24.008, 5.2.1.2)
            call.originating().proceed();
        }
        if (isEmergency) {
            // also 112 and 911 in an ordinary SETUP
            emergencyNumber.ifPresentOrElse(
                    number -> {
                        call.turn(number);
                        reach(call);
                    },
                    call::announce);
        } else if (call.to().isEmpty()) {
            call.refuse(Cause.INVALID_NUMBER_FORMAT);
        } else if (!mobility.register().isAssigned(call.to().get())) {
            call.refuse(Cause.UNASSIGNED_NUMBER);
        } else if (calls.size() > MAX_CALLS) {
            call.refuse(Cause.SWITCHING_EQUIPMENT_CONGESTION);
        } else {
            call.originating().proceed();
            Link caller = call.originating().link();
            if (caller.hasSubscriber()) {
                SsCode unconditional = SsCode.FORWARDING_UNCONDITIONAL;
                caller.subscriber()
                        .services()
                        .forwarding(unconditional)
                        .ifPresent(to -> call.originating().notify(NotifySs.FORWARDING_ACTIVE, unconditional));
            }
            reach(call);
        }
    }

    private void reach(NetworkCall call) {
        if (forwarding(call, SsCode.FORWARDING_UNCONDITIONAL).isPresent()) {
            // forwarded too often, the call ends without ringing this subscriber
            fail(call, SsCode.FORWARDING_UNCONDITIONAL, Cause.CALL_REJECTED);
            return;
        }
        Optional<Link> location = subscriberOf(call).flatMap(mobility::locationOf);
        if (location.isEmpty()) {
            fail(call, SsCode.FORWARDING_ON_NOT_REACHABLE, Cause.DESTINATION_OUT_OF_ORDER);
            return;
        }
        LinkCalls called = on(location.get());
        Optional<TransactionIdentifier> transaction = called.freeTransaction();
        boolean waits =
                hasCallWaiting(call) && location.get() != call.originating().link() && called.allowsWaitingCall();
        if (!called.live().isEmpty() && !waits || transaction.isEmpty()) {
            fail(call, SsCode.FORWARDING_ON_BUSY, Cause.USER_BUSY);
        } else if (called.isClearing() && !waits) {
            call.hold(called);
        } else {
            call.extend(called, transaction.get());
        }
    }

    HomeRegister home() {
        return mobility.register().home();
    }

    private Optional<Subscriber> subscriberOf(NetworkCall call) {
        return call.target().flatMap(mobility.register()::ofNumber);
    }

    private boolean hasCallWaiting(NetworkCall call) {
        return subscriberOf(call)
                .filter(called -> called.services().hasCallWaiting(callWaiting))
                .isPresent();
    }

    private void fail(NetworkCall call, SsCode condition, Cause cause) {
        if (!divert(call, condition)) {
            call.refuse(cause);
        }
    }

    /** The called subscriber's forwarding of this call on a condition. */
    Optional<Msisdn> forwarding(NetworkCall call, SsCode condition) {
        return subscriberOf(call)
                .flatMap(called -> called.services().forwarding(condition))
                .map(home()::called);
    }

    /** Ringing time of the called mobile before a call is forwarded. */
    long noReplyNanos(NetworkCall call) {
        return TimeUnit.SECONDS.toNanos(
                subscriberOf(call).orElseThrow().services().noReplySeconds());
    }

    /**
     * Forwards the call if the called subscriber has set it (TS 23.082, 1.3).
     *
     * @return true if it continues, or has been refused
     */
    boolean divert(NetworkCall call, SsCode condition) {
        Optional<Msisdn> next = forwarding(call, condition);
        Optional<Link> forwarding = subscriberOf(call).flatMap(mobility::locationOf);
        if (next.isEmpty() || !call.forward(next.get(), condition)) {
            return false;
        }
        if (condition != SsCode.FORWARDING_UNCONDITIONAL) {
            forwarding.ifPresent(
                    link -> on(link).live().forEach(leg -> leg.notify(NotifySs.INCOMING_CALL_FORWARDED, condition)));
        }
        if (mobility.register().isAssigned(next.get())) {
            reach(call);
        } else {
            call.refuse(Cause.UNASSIGNED_NUMBER);
        }
        return true;
    }

    /** As {@link #divert(NetworkCall, SsCode)}, for a call not taken by the called mobile. */
    boolean divert(NetworkCall call, Cause why) {
        return switch (why) {
            case USER_BUSY -> divert(call, SsCode.FORWARDING_ON_BUSY);
            case DESTINATION_OUT_OF_ORDER, NO_USER_RESPONDING -> divert(call, SsCode.FORWARDING_ON_NOT_REACHABLE);
            case USER_ALERTING_NO_ANSWER -> divert(call, SsCode.FORWARDING_ON_NO_REPLY);
            default -> false;
        };
    }

    /** Continues calls held for a link after a change of its legs. */
    public void legsChanged(Link link) {
        if (links.containsKey(link)) {
            links.get(link).releaseHeld(call -> {
                try {
                    reach(call);
                } catch (RuntimeException e) {
                    call.originating().link().failed(e);
                }
            });
        }
    }

    long nextCallId() {
        return ++lastCallId;
    }

    /** Called by a call that has entered a state. */
    void changed(NetworkCall call) {
        if (call.state() == CallProgress.RELEASED) {
            calls.remove(call);
        } else {
            calls.add(call);
        }
        changes.accept(call);
    }

    /**
     * Passes a speech frame on unchanged, with the speaker's numbering and losses; the tone of a signalled key replaces
     * it.
     */
    public void switchSpeech(Link link, IpaFrame frame) {
        CallLeg leg = on(link).speakingLeg();
        CallLeg listening = leg == null ? null : leg.listener();
        if (listening != null) {
            speechFramesSwitched++;
            IpaFrame audible = leg.audible(frame);
            if (audible != null) {
                listening.link().access().sendSpeech(audible);
            }
            keyTap.passed(leg, frame.payload());
        }
    }

    /** Ends calls that need the unavailable speech path of a mobile. */
    public void speechRefused(Link link, Cause cause) {
        on(link).live().stream().filter(leg -> leg.state().needsSpeechPath()).forEach(leg -> leg.refuseSpeech(cause));
    }

    /** True if these octets are an RTP packet of version 2. */
    public static boolean isRtp(byte[] payload) {
        return payload.length > RTP_HEADER_LENGTH && (payload[0] & RTP_VERSION_MASK) == RTP_VERSION_2;
    }
}
