package simgsm.phone.store;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The newest calls of each kind. */
public final class CallLog {
    /** Calls kept of each kind; the oldest are dropped. */
    public static final int CAPACITY = 30;

    private List<CallRecord> records = List.of();
    private int unseenMissed;

    public CallLog() {}

    /** Oldest first; each change makes a new list, so a snapshot may keep it. */
    public List<CallRecord> records() {
        return records;
    }

    /** Newest first. */
    public List<CallRecord> newest(CallRecord.Kind kind) {
        List<CallRecord> found = new ArrayList<>(
                records.stream().filter(record -> record.kind() == kind).toList());
        Collections.reverse(found);
        return found;
    }

    public void add(CallRecord record) {
        List<CallRecord> next = new ArrayList<>(records);
        next.add(record);
        if (newest(record.kind()).size() >= CAPACITY) {
            next.remove(next.stream()
                    .filter(old -> old.kind() == record.kind())
                    .findFirst()
                    .orElseThrow());
        }
        records = List.copyOf(next);
        unseenMissed += record.kind() == CallRecord.Kind.MISSED ? 1 : 0;
    }

    public void remove(CallRecord record) {
        List<CallRecord> next = new ArrayList<>(records);
        next.remove(record);
        records = List.copyOf(next);
    }

    public void clear() {
        records = List.of();
        unseenMissed = 0;
    }

    /** Missed calls not yet seen by the user. */
    public int unseenMissed() {
        return unseenMissed;
    }

    /** The user has seen the missed calls. */
    public void missedSeen() {
        unseenMissed = 0;
    }
}
