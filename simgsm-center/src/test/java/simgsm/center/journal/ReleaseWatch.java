package simgsm.center.journal;

import java.util.HashMap;
import java.util.Map;
import simgsm.air.CallControl;
import simgsm.air.TransactionIdentifier;

/** RELEASE of one call goes down twice at most: at first, and after T308 (TS 24.008, 5.4.4.3). */
final class ReleaseWatch {
    private static final int MOST_RELEASES = 2;

    private final Map<TransactionIdentifier, Integer> releases = new HashMap<>();

    /** A message of call control goes down on the connection that is watched. */
    void sent(CallControl message) {
        if (message instanceof CallControl.Release) {
            int count = releases.merge(message.transaction(), 1, Integer::sum);
            Invariant.holds(
                    count <= MOST_RELEASES,
                    () -> "RELEASE of transaction " + message.transaction() + " is sent " + count + " times");
        } else {
            releases.remove(message.transaction());
        }
    }
}
