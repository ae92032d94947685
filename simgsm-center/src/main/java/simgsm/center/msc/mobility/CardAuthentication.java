package simgsm.center.msc.mobility;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.MobilityManagement;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.octets.OctetString;
import simgsm.sim.GsmVector;
import simgsm.sim.SimCard;
import simgsm.timer.Timer;

/**
 * Authentication of the card on one link (TS 24.008, 4.3.2). Every location update is authenticated; a service only if the
 * mobile names another key sequence number than the latest, or that key was used for {@link #MAX_KEY_USES} services.
 */
public final class CardAuthentication {
    /** The network's choice. */
    public static final int MAX_KEY_USES = 10;

    private static final int MAX_OUTDATED = 8;

    private final Link link;
    /** Expected answers to cancelled challenges; they may arrive late on another radio connection. */
    private final Deque<OctetString> outdated = new ArrayDeque<>();

    private OctetString expected;
    private OctetString cipherKey;
    private boolean isCipheringBegun;
    /** Receives the outcome of the current challenge; null without one. */
    private Consumer<Boolean> ended;

    private Timer guard;
    /** Key sequence numbers of the latest successful challenge, and of the latest challenge. */
    private int keySequence = MobilityManagement.NO_KEY;

    private int challengeSequence = MobilityManagement.NO_KEY;
    private int keyUses;

    CardAuthentication(Link link) {
        this.link = link;
    }

    /** True if a challenge is unanswered. */
    boolean isAwaited() {
        return ended != null;
    }

    /** True if the latest challenge was followed by the begin of ciphering, which accepts a service (TS 24.008, 4.5.1.1). */
    boolean beganToCipher() {
        return isCipheringBegun;
    }

    /** Counts a service with the mobile's key number; false if that key is not valid for one. */
    boolean useKey(int namedKeySequence) {
        boolean isValid =
                keySequence != MobilityManagement.NO_KEY && namedKeySequence == keySequence && keyUses < MAX_KEY_USES;
        keyUses += isValid ? 1 : 0;
        return isValid;
    }

    /**
     * Challenges the card. Without an answer within T3260 the radio connection is released.
     *
     * @param outcome receives true if the card has its key; its radio connection is then ciphered
     */
    void begin(SimCard card, OctetString rand, Consumer<Boolean> outcome) {
        cancel();
        GsmVector vector = card.vector(rand);
        expected = vector.sres();
        cipherKey = vector.kc();
        ended = outcome;
        challengeSequence = (challengeSequence + 1) % MobilityManagement.NO_KEY;
        guard = link.timers().start(NetworkTimer.T3260.nanos(), this::unanswered);
        link.send(new MobilityManagement.AuthenticationRequest(challengeSequence, rand, Optional.empty()));
    }

    /** Handles the answer; false for any other message, or without a challenge. */
    boolean receive(MobilityManagement message) {
        if (!isAwaited()) {
            return false;
        }
        if (message instanceof MobilityManagement.AuthenticationResponse response) {
            if (!outdated.remove(response.response())) {
                answered(response.response().equals(expected));
            }
            return true;
        }
        if (message instanceof MobilityManagement.AuthenticationFailure) {
            end(false);
            return true;
        }
        return false;
    }

    /** A card with its key is first ciphered, within the time of T3260. */
    private void answered(boolean hasKey) {
        if (!hasKey) {
            end(false);
            return;
        }
        Consumer<Boolean> awaited = ended;
        link.access().cipher(cipherKey, begins -> {
            if (ended == awaited) {
                isCipheringBegun = begins;
                end(true);
            }
        });
    }

    private void end(boolean hasKey) {
        Consumer<Boolean> outcome = ended;
        stop();
        keySequence = hasKey ? challengeSequence : MobilityManagement.NO_KEY;
        keyUses = 0;
        outcome.accept(hasKey);
    }

    private void unanswered() {
        cancel();
        keySequence = MobilityManagement.NO_KEY;
        link.loseTransactions();
        link.radio().release();
    }

    /** Ends the current challenge without an outcome. */
    void cancel() {
        if (isAwaited()) {
            outdated.addLast(expected);
            if (outdated.size() > MAX_OUTDATED) {
                outdated.removeFirst();
            }
            stop();
        }
    }

    private void stop() {
        link.timers().cancel(guard);
        ended = null;
    }
}
