package simgsm.center.smpp;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.center.smsc.Recipient;

/** The sessions that serve the same numbers, or take the receipts of the same application. */
final class Route {
    private final List<EsmeSession> sessions = new ArrayList<>(1);
    /** Receivers for whom something waits until a session has room; in the order of their turn. */
    private final Set<Recipient> starved = new LinkedHashSet<>();

    private Recipient hasTurn;

    boolean isEmpty() {
        return sessions.isEmpty();
    }

    void add(EsmeSession session) {
        sessions.add(session);
    }

    void remove(EsmeSession session) {
        sessions.remove(session);
    }

    /** Whether something may be sent to this receiver now; if not, its turn will come. */
    boolean admits(Recipient receiver) {
        boolean mayGo = starved.isEmpty() || receiver.equals(hasTurn);
        if (mayGo && idlest().hasRoom()) {
            return true;
        }
        starved.add(receiver);
        return false;
    }

    /** The one with the fewest answers outstanding, so that a stuck one gets nothing more. */
    EsmeSession idlest() {
        EsmeSession best = sessions.get(0);
        for (int i = 1; i < sessions.size(); i++) {
            if (sessions.get(i).outstanding() < best.outstanding()) {
                best = sessions.get(i);
            }
        }
        return best;
    }

    /** Something has been sent; whoever wants to send more waits for the next turn if others wait. */
    void used() {
        hasTurn = null;
    }

    /** Gives turns while there is room and somebody waits. */
    void giveTurns(SmppServer server) {
        while (!starved.isEmpty() && !sessions.isEmpty() && idlest().hasRoom()) {
            Recipient next = starved.iterator().next();
            starved.remove(next);
            hasTurn = next;
            server.center().roomFor(next);
            hasTurn = null;
        }
    }
}
