package simgsm.center.msc;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.MobilityManagement;
import simgsm.octets.OctetString;
import simgsm.sim.GsmVector;
import simgsm.sim.SimCard;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * How sure the network is of the card at the end of a link (TS 24.008, 4.3.2): a challenge, its answer, and how long that
 * holds. Every registration is challenged; a service only if the mobile names another key than the one agreed last, or has
 * used that for {@link #MAX_KEY_USES} services.
 */
final class Authenticity {
    /** The network's policy. */
    static final int MAX_KEY_USES = 10;

    private static final int OUTDATED_KEPT = 8;

    /** T3260 (TS 24.008, table 11.2). */
    private static final long T3260_NANOS = Duration.ofSeconds(12).toNanos();

    private final Link link;
    private final Timers timers;
    /** Answers to challenges that were given up: one may still come, late, on a later radio connection. */
    private final Deque<OctetString> outdated = new ArrayDeque<>();

    private OctetString expected;
    /** Told the outcome of the challenge under way; null while there is none. */
    private Consumer<Boolean> outcome;

    private Timer guard;
    /** The key agreed last, by its number; and the number of the challenge made last. */
    private int keySequence = MobilityManagement.NO_KEY;

    private int challengeSequence = MobilityManagement.NO_KEY;
    private int keyUses;

    Authenticity(Link link, Timers timers) {
        this.link = link;
        this.timers = timers;
    }

    /** Whether an answer is awaited. */
    boolean isAwaited() {
        return outcome != null;
    }

    /** Whether a service may be had for the key that the mobile names; counts as its use. */
    boolean isFresh(int namedKeySequence) {
        boolean isFresh =
                keySequence != MobilityManagement.NO_KEY && namedKeySequence == keySequence && keyUses < MAX_KEY_USES;
        keyUses += isFresh ? 1 : 0;
        return isFresh;
    }

    /**
     * Challenges the card; no answer in time ends the radio connection.
     *
     * @param ended told whether the card has the key
     */
    void demand(SimCard card, OctetString rand, Consumer<Boolean> ended) {
        cancel();
        expected = GsmVector.of(card.functions(), rand).sres();
        outcome = ended;
        challengeSequence = (challengeSequence + 1) % MobilityManagement.NO_KEY;
        guard = timers.start(T3260_NANOS, this::unanswered);
        link.send(new MobilityManagement.AuthenticationRequest(challengeSequence, rand, Optional.empty()));
    }

    /** Takes the answer. Returns false if the message is none, or none is awaited. */
    boolean receive(MobilityManagement message) {
        if (!isAwaited()) {
            return false;
        }
        if (message instanceof MobilityManagement.AuthenticationResponse response) {
            if (!outdated.remove(response.response())) {
                end(response.response().equals(expected));
            }
        } else if (message instanceof MobilityManagement.AuthenticationFailure) {
            end(false);
        } else {
            return false;
        }
        return true;
    }

    private void end(boolean proven) {
        Consumer<Boolean> told = outcome;
        forget();
        keySequence = proven ? challengeSequence : MobilityManagement.NO_KEY;
        keyUses = 0;
        told.accept(proven);
    }

    private void unanswered() {
        cancel();
        keySequence = MobilityManagement.NO_KEY;
        if (link.registration != null) {
            link.registration.cancel();
        }
        link.loseTransactions();
        link.radio.release();
    }

    /** Gives the challenge under way up. */
    void cancel() {
        if (isAwaited()) {
            outdated.addLast(expected);
            if (outdated.size() > OUTDATED_KEPT) {
                outdated.removeFirst();
            }
            forget();
        }
    }

    private void forget() {
        timers.cancel(guard);
        outcome = null;
    }
}
