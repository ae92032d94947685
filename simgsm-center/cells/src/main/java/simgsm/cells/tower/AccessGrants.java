package simgsm.cells.tower;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignment;
import simgsm.rr.ImmediateAssignmentReject;
import simgsm.rr.RequestReference;

/** The access grant channel of a tower: mobiles that wait for an answer to their CHANNEL REQUEST. */
final class AccessGrants {
    /** Maximum of waiting mobiles; more are ignored. */
    private static final int MOST = 1_000;

    private final Set<AccessUser> waiting = new LinkedHashSet<>();

    /** @return false if too many wait */
    boolean add(AccessUser user) {
        boolean hasRoom = waiting.size() < MOST;
        if (hasRoom) {
            waiting.add(user);
        }
        return hasRoom;
    }

    void remove(AccessUser user) {
        waiting.remove(user);
    }

    void clear() {
        waiting.clear();
    }

    /** Tells all mobiles of an IMMEDIATE ASSIGNMENT or its reject; other messages are ignored. */
    void answer(OctetString octets) throws ProtocolViolation {
        if (ImmediateAssignment.isOne(octets)) {
            ImmediateAssignment assignment = ImmediateAssignment.decode(octets);
            List.copyOf(waiting).forEach(access -> access.granted(assignment));
        } else if (ImmediateAssignmentReject.isOne(octets)) {
            ImmediateAssignmentReject reject = ImmediateAssignmentReject.decode(octets);
            for (RequestReference reference : reject.references()) {
                List.copyOf(waiting).forEach(access -> access.refused(reference, reject.waitSeconds()));
            }
        }
    }
}
