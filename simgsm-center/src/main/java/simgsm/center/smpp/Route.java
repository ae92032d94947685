package simgsm.center.smpp;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.center.smsc.Destination;

/** Sessions that serve the same numbers, or the receipts of the same application, and their destinations. */
final class Route {
    private final List<EsmeSession> sessions = new ArrayList<>(1);
    /** Destinations that wait for space in a session's window, in the order of their turns. */
    private final Set<Destination> blocked = new LinkedHashSet<>();

    /** May send although others are blocked; null between turns. */
    private Destination hasTurn;

    /** True if the application may still serve this number: a subscriber may have registered with it since the bind. */
    boolean permits(Msisdn number) {
        return sessions.get(0).permits(number.digits());
    }

    boolean isEmpty() {
        return sessions.isEmpty();
    }

    void add(EsmeSession session) {
        sessions.add(session);
    }

    void remove(EsmeSession session) {
        sessions.remove(session);
    }

    /** True if a message may be sent to this destination now; otherwise the destination is blocked until its turn. */
    boolean admits(Destination destination) {
        boolean mayGo = blocked.isEmpty() || destination.equals(hasTurn);
        if (mayGo && best().isPresent()) {
            return true;
        }
        blocked.add(destination);
        return false;
    }

    int blocked() {
        return blocked.size();
    }

    /** Unblocks a destination without messages. */
    void emptied(Destination destination) {
        blocked.remove(destination);
    }

    /**
     * The session for the next deliver_sm: one with a due trial, else one that answers before one with a recent
     * timeout, else the one with the fewest unanswered; empty if none has space.
     */
    Optional<EsmeSession> best() {
        EsmeSession best = null;
        for (EsmeSession session : sessions) {
            if (session.hasRoom() && (best == null || isBetter(session, best))) {
                best = session;
            }
        }
        return Optional.ofNullable(best);
    }

    private static boolean isBetter(EsmeSession session, EsmeSession other) {
        int byRank = Integer.compare(session.deliveryRank(), other.deliveryRank());
        return byRank == 0 ? session.outstanding() < other.outstanding() : byRank < 0;
    }

    /** Ends the turn after a message was sent. */
    void used() {
        hasTurn = null;
    }

    /** Lets blocked destinations send, one message each, while there is space. */
    void giveTurns(SmppServer server) {
        while (!blocked.isEmpty() && best().isPresent()) {
            Destination next = blocked.iterator().next();
            blocked.remove(next);
            hasTurn = next;
            server.center().roomFor(next);
            hasTurn = null;
        }
    }
}
