package simgsm.center.smpp;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.center.smsc.Destination;

/** Sessions that serve the same numbers, or the receipts of the same application; and the destinations that share them. */
final class Route {
    private final List<EsmeSession> sessions = new ArrayList<>(1);
    /** Destinations that wait for room in a session's window, in the order of their turns. */
    private final Set<Destination> blocked = new LinkedHashSet<>();

    /** May send although others are blocked; null between turns. */
    private Destination hasTurn;

    /** Whether the application may serve this number still: a subscriber may have registered under it since the bind. */
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

    /** Whether a message may be sent to this destination now; if not, the destination is blocked until its turn. */
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

    /** Nothing waits for this destination any more. */
    void emptied(Destination destination) {
        blocked.remove(destination);
    }

    /**
     * The session that gets the next deliver_sm: one whose trial is due, else one that answers before one that has just let
     * a response time out, else the one with the fewest unanswered; empty if none has room.
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

    /** A message has been sent: the turn is over. */
    void used() {
        hasTurn = null;
    }

    /** Lets blocked destinations send, one message each, while there is room. */
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
