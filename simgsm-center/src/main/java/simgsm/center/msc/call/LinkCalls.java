package simgsm.center.msc.call;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Cause;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallState;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.msc.link.RadioAccess.SpeechNeed;
import simgsm.timer.Timer;

/**
 * The calls on one link: its legs, and incoming calls held while its last call is being cleared. Clearing usually takes
 * some milliseconds, so a number can be dialled again directly after the clearing.
 */
final class LinkCalls {
    private static final int TRANSACTIONS = 7;

    private final Link link;
    private final List<CallLeg> legs = new ArrayList<>(2);
    private final Map<NetworkCall, Timer> held = new LinkedHashMap<>();

    LinkCalls(Link link) {
        this.link = link;
    }

    Link link() {
        return link;
    }

    /** Handles a leg's change of state. */
    void changed(CallLeg leg) {
        if (leg.state() == NetworkCallState.NULL) {
            legs.remove(leg);
            link.paging().cancel(leg);
        } else if (!legs.contains(leg)) {
            legs.add(leg);
        }
        link.access().setSpeechNeed(speechNeed());
        link.touch();
    }

    private SpeechNeed speechNeed() {
        return legs.stream()
                .map(CallLeg::speechNeed)
                .max(Comparator.naturalOrder())
                .orElse(SpeechNeed.NONE);
    }

    /** @param received the transaction as written by the mobile */
    Optional<CallLeg> leg(TransactionIdentifier received) {
        TransactionIdentifier ours = received.answered();
        return legs.stream().filter(leg -> leg.transaction().equals(ours)).findFirst();
    }

    Optional<TransactionIdentifier> freeTransaction() {
        for (int value = 0; value < TRANSACTIONS; value++) {
            TransactionIdentifier candidate = new TransactionIdentifier(value, false);
            if (legs.stream().noneMatch(leg -> leg.transaction().equals(candidate))) {
                return Optional.of(candidate);
            }
        }
        return Optional.empty();
    }

    /** The leg whose state passes speech, or null. */
    CallLeg speakingLeg() {
        for (int i = 0; i < legs.size(); i++) {
            if (legs.get(i).speaks()) {
                return legs.get(i);
            }
        }
        return null;
    }

    /** Legs that are not being cleared. */
    List<CallLeg> live() {
        return legs.stream().filter(leg -> !leg.state().isClearing()).toList();
    }

    /** True if exactly one call is active, so that a second one may wait (TS 22.083). */
    boolean allowsWaitingCall() {
        List<CallLeg> live = live();
        return live.size() == 1 && live.get(0).state() == NetworkCallState.ACTIVE;
    }

    boolean isClearing() {
        return legs.stream().anyMatch(leg -> leg.state().isClearing());
    }

    /** True if a leg uses the radio connection or will use it without paging. */
    boolean needsRadio() {
        return legs.stream().anyMatch(leg -> leg.state() != NetworkCallState.MM_CONNECTION_PENDING);
    }

    void radioLost() {
        List.copyOf(legs).forEach(CallLeg::linkLost);
    }

    /** Holds a call to this link until {@link #releaseHeld}; after the timer's expiry the mobile counts as busy. */
    void hold(NetworkCall call) {
        Timer timer = call.originating().link().timers().start(NetworkTimer.HELD_CALL.nanos(), () -> {
            forget(call);
            call.refuse(Cause.USER_BUSY);
        });
        held.put(call, timer);
    }

    /** Removes a held call that has ended or continues. */
    void forget(NetworkCall call) {
        link.timers().cancel(held.remove(call));
    }

    /** Passes on the held calls if the mobile has finished clearing, or is lost. */
    void releaseHeld(Consumer<NetworkCall> next) {
        if (!held.isEmpty() && (link.isClosed() || !isClearing())) {
            List<NetworkCall> free = List.copyOf(held.keySet());
            free.forEach(this::forget);
            free.forEach(next);
        }
    }
}
