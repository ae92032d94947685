package simgsm.cells.tower;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelNumber;
import simgsm.air.ChannelNumber.Kind;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignment;
import simgsm.rr.ImmediateAssignmentReject;
import simgsm.rr.RequestReference;
import simgsm.timer.Timers;

/** The random access and access grant channels of a tower: mobiles that wait for an answer to their CHANNEL REQUEST. */
public final class AccessGrants {
    private static final ChannelNumber RACH = ChannelNumber.of(Kind.RACH, 0);

    /** Maximum of waiting mobiles; more are ignored. */
    private static final int MOST = 1_000;

    private final Set<AccessUser> waiting = new LinkedHashSet<>();

    private final BaseStation tower;
    private final Timers timers;

    AccessGrants(BaseStation tower, Timers timers) {
        this.tower = tower;
        this.timers = timers;
    }

    /**
     * Handles a CHANNEL REQUEST received in this frame.
     *
     * @param access its octet;
     * @param delay of the burst, as timing advance
     * @param user listens to the access grant channel from now on
     */
    public RequestReference request(int access, int delay, AccessUser user) {
        RequestReference reference = RequestReference.at(access, FrameClock.frameAt(timers.nowNanos()));
        tower.capture().access(access);
        if (waiting.size() < MOST) {
            waiting.add(user);
            tower.send(RslPdu.of(RslType.CHANNEL_REQUIRED, RACH)
                    .with(RslElement.REQUEST_REFERENCE, reference.octets())
                    .with(RslElement.ACCESS_DELAY, delay));
        }
        return reference;
    }

    /** Removes a mobile from the access grant channel. */
    public void end(AccessUser user) {
        waiting.remove(user);
    }

    void clear() {
        waiting.clear();
    }

    /** Tells all mobiles of an IMMEDIATE ASSIGNMENT or its reject; other messages are ignored. */
    void answer(OctetString octets) throws ProtocolViolation {
        tower.capture().grant(octets);
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
