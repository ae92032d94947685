package simgsm.center.smpp;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.center.smsc.Destination;

/** Sessions that serve the same numbers, or the receipts of the same application; and the destinations that share them. */
final class Route {
    private final List<EsmeSession> sessions = new ArrayList<>(1);
    /** Destinations that wait for room in a session's window, in the order of their turns. */
    private final Set<Destination> blocked = new LinkedHashSet<>();

    /** May send although others are blocked; null between turns. */
    private Destination hasTurn;

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
        if (mayGo && leastLoaded().hasRoom()) {
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

    /** The session with the fewest unanswered deliver_sm. */
    EsmeSession leastLoaded() {
        EsmeSession best = sessions.get(0);
        for (int i = 1; i < sessions.size(); i++) {
            if (sessions.get(i).outstanding() < best.outstanding()) {
                best = sessions.get(i);
            }
        }
        return best;
    }

    /** A message has been sent: the turn is over. */
    void used() {
        hasTurn = null;
    }

    /** Lets blocked destinations send, one message each, while there is room. */
    void giveTurns(SmppServer server) {
        while (!blocked.isEmpty() && !sessions.isEmpty() && leastLoaded().hasRoom()) {
            Destination next = blocked.iterator().next();
            blocked.remove(next);
            hasTurn = next;
            server.center().roomFor(next);
            hasTurn = null;
        }
    }
}
