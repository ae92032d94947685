package simgsm.cells.tower;

import simgsm.rr.ImmediateAssignment;
import simgsm.rr.RequestReference;

/** A mobile that has sent CHANNEL REQUESTs and listens to the access grant channel. */
public interface AccessUser {
    void granted(ImmediateAssignment assignment);

    void refused(RequestReference reference, int waitSeconds);
}
