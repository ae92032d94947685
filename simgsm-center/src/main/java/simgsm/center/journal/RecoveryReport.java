package simgsm.center.journal;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The faults found by a recovery, in the order of the files. */
final class RecoveryReport {
    private final List<Damage> damages = new ArrayList<>();
    /** The reason of a missing copy of octets. */
    private final Map<Damage, String> notKept = new HashMap<>();

    private final List<String> remarks = new ArrayList<>();
    private long lostRecords;
    private boolean isLossUnknown;

    /** Octets without a valid record. */
    void damaged(Damage damage) {
        damages.add(damage);
    }

    /** The octets could not be copied and remain in place. */
    void notKept(Damage damage, String reason) {
        notKept.put(damage, reason);
    }

    List<Damage> damagesOf(String file) {
        return damages.stream().filter(damage -> damage.file().equals(file)).toList();
    }

    /** Reports missing records; ignores a count of 0 or less. */
    void lost(String where, long records) {
        if (records > 0) {
            lostRecords += records;
            remarks.add(where + ": " + records + (records == 1 ? " record is lost" : " records are lost"));
        }
    }

    /** An unknown number of records is lost. */
    void lostUnknown(String remark) {
        isLossUnknown = true;
        remarks.add(remark);
    }

    /** Number of records certainly lost. */
    long lostRecords() {
        return lostRecords;
    }

    /** True if records are lost, of known number or not. */
    boolean isLossy() {
        return lostRecords > 0 || isLossUnknown;
    }

    /**
     * Logs the damage, and losses at the level ERROR.
     *
     * @param saved messages in the journal
     */
    void log(Logger log, long saved) {
        damages.forEach(damage -> log.log(Level.WARNING, text(damage)));
        if (isLossy()) {
            remarks.forEach(remark -> log.log(Level.ERROR, remark));
            log.log(
                    Level.ERROR,
                    "the journal is damaged: messages saved: {0}, records lost: {1}",
                    Long.toString(saved),
                    lostText());
        } else if (saved > 0 || !damages.isEmpty()) {
            log.log(Level.INFO, "messages in the journal: {0}; none is lost", Long.toString(saved));
        }
    }

    private String lostText() {
        String atLeast = lostRecords == 0 ? "unknown" : "at least " + lostRecords;
        return isLossUnknown ? atLeast : Long.toString(lostRecords);
    }

    private String text(Damage damage) {
        return notKept.containsKey(damage)
                ? damage.place() + "; left in place: " + notKept.get(damage)
                : damage + "; kept in " + FileNames.damaged(damage.file(), damage.from());
    }
}
