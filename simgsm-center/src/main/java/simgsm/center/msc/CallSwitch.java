package simgsm.center.msc;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.ToneSet;
import simgsm.timer.Timers;

/** Number analysis and switching: from a SETUP to a call between two legs, and speech between them. */
final class CallSwitch {
    /** Calls at a time; further ones are refused with cause 42. */
    static final int MAX_CALLS = 5_000;

    private static final int TRANSACTIONS = 7;
    /** RTP version 2 in the two highest bits of the first octet (RFC 3550, 5.1). */
    private static final int RTP_VERSION_MASK = 0xc0;

    private static final int RTP_VERSION_2 = 0x80;
    private static final int RTP_HEADER_LENGTH = 12;

    private final Mobility mobility;
    private final Timers timers;
    private final Consumer<NetworkCall> changes;
    private final boolean callWaiting;
    private final Set<NetworkCall> calls = new LinkedHashSet<>();
    private final HeldCalls heldCalls;
    private final Optional<ToneSet> tones;
    private final KeyTap keyTap = new KeyTap();
    private long speechFramesSwitched;
    private long speechFramesUnheard;

    /**
     * @param tones that callers are made to hear, if any
     * @param callWaiting whether a second call is offered to who is in one
     * @param changes told of each call that enters a state
     */
    CallSwitch(
            Mobility mobility,
            Timers timers,
            Optional<ToneSet> tones,
            boolean callWaiting,
            Consumer<NetworkCall> changes) {
        this.tones = tones;
        this.mobility = mobility;
        this.timers = timers;
        this.changes = changes;
        this.callWaiting = callWaiting;
        this.heldCalls = new HeldCalls(timers);
    }

    /** Calls from their SETUP to the first clearing message. */
    Collection<NetworkCall> calls() {
        return Collections.unmodifiableSet(calls);
    }

    /** What callers are made to hear of calls that are not connected. */
    Optional<ToneSet> tones() {
        return tones;
    }

    KeyTap keyTap() {
        return keyTap;
    }

    long speechFramesSwitched() {
        return speechFramesSwitched;
    }

    /** Speech frames that came while no call was active. */
    long speechFramesUnheard() {
        return speechFramesUnheard;
    }

    /** Call control messages reach their leg; what belongs to none is answered as TS 24.008, 8.3 says. */
    void receive(Link link, CallControl message) {
        Optional<CallLeg> leg = legOf(link, message.transaction());
        if (message instanceof CallControl.Setup setup) {
            if (leg.isEmpty() && !setup.transaction().fromOtherSide()) {
                open(link, setup);
            }
        } else if (leg.isPresent()) {
            leg.get().receive(message);
        } else if (wantsAnswer(message)) {
            refuse(link, message.transaction(), Cause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private static boolean wantsAnswer(CallControl message) {
        return !(message instanceof CallControl.ReleaseComplete)
                && !(message instanceof CallControl.Status status && status.callState() == 0);
    }

    /** The state of the call that a message from the mobile belongs to, as STATUS codes it; 0 if there is none. */
    static int stateCode(Link link, TransactionIdentifier received) {
        return legOf(link, received).map(leg -> leg.state().code()).orElse(0);
    }

    private static void refuse(Link link, TransactionIdentifier transaction, Cause cause) {
        link.send(new CallControl.ReleaseComplete(transaction.answered(), Optional.of(cause)));
    }

    private static Optional<CallLeg> legOf(Link link, TransactionIdentifier received) {
        return link.callLegs.stream()
                .filter(leg -> leg.transaction().equals(received.answered()))
                .findFirst();
    }

    private void open(Link link, CallControl.Setup setup) {
        if (!link.radio.takeService()) {
            refuse(link, setup.transaction(), Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
            return;
        }
        NetworkCall call = new NetworkCall(this, link, setup.transaction().answered(), setup.called(), timers);
        call.originating().receive(setup);
    }

    /** Finds the called party, and what stands against calling it. */
    void route(NetworkCall call) {
        if (tones.isPresent()) {
            // Whoever is to hear why the call fails has a channel first (TS 24.008, 5.2.1.2).
            call.originating().proceed();
        }
        if (call.to().isEmpty()) {
            call.refuse(Cause.INVALID_NUMBER_FORMAT);
        } else if (!mobility.register().isAssigned(call.to().get())) {
            call.refuse(Cause.UNASSIGNED_NUMBER);
        } else if (calls.size() > MAX_CALLS) {
            call.refuse(Cause.SWITCHING_EQUIPMENT_CONGESTION);
        } else {
            call.originating().proceed();
            reach(call);
        }
    }

    private void reach(NetworkCall call) {
        Optional<Link> called = call.to().flatMap(mobility.register()::ofNumber).flatMap(mobility::locationOf);
        if (called.isEmpty()) {
            call.refuse(Cause.DESTINATION_OUT_OF_ORDER);
            return;
        }
        Optional<TransactionIdentifier> transaction = freeTransaction(called.get());
        boolean waits = callWaiting
                && called.get() != call.originating().link()
                && called.get().mayLetWait();
        if (called.get().isInCall() && !waits || transaction.isEmpty()) {
            call.refuse(Cause.USER_BUSY);
        } else if (called.get().isClearingCall() && !waits) {
            heldCalls.hold(call, called.get());
        } else {
            call.extend(called.get(), transaction.get());
        }
    }

    private static Optional<TransactionIdentifier> freeTransaction(Link link) {
        for (int value = 0; value < TRANSACTIONS; value++) {
            TransactionIdentifier candidate = new TransactionIdentifier(value, false);
            if (link.callLegs.stream().noneMatch(leg -> leg.transaction().equals(candidate))) {
                return Optional.of(candidate);
            }
        }
        return Optional.empty();
    }

    /** Legs may have come free: calls that waited for them go on. */
    void legsChanged() {
        heldCalls.release(call -> {
            try {
                reach(call);
            } catch (RuntimeException e) {
                call.originating().link().failed(e);
            }
        });
    }

    /** A call has entered a state; called by the call itself. */
    void changed(NetworkCall call) {
        if (call.state() == CallProgress.RELEASED) {
            calls.remove(call);
            heldCalls.forget(call);
        } else {
            calls.add(call);
        }
        changes.accept(call);
    }

    /**
     * Passes a speech frame on as it is, unless a signalled key sounds in its place. Nothing is kept and nothing is altered,
     * so the far end sees the speaker's own numbering and loss.
     */
    void switchSpeech(Link link, IpaFrame frame) {
        CallLeg leg = link.speakingLeg();
        CallLeg listening = leg == null ? null : leg.listener();
        if (listening == null) {
            speechFramesUnheard++;
        } else {
            speechFramesSwitched++;
            IpaFrame audible = leg.audible(frame);
            if (audible != null) {
                listening.link().port.send(audible);
            }
            keyTap.passed(leg, frame.payload());
        }
    }

    static boolean isRtp(byte[] payload) {
        return payload.length > RTP_HEADER_LENGTH && (payload[0] & RTP_VERSION_MASK) == RTP_VERSION_2;
    }
}
