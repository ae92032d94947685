package simgsm.center.msc;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import simgsm.air.Direction;
import simgsm.center.msc.link.Lifeline;
import simgsm.center.msc.link.Trace;
import simgsm.octets.OctetString;
import simgsm.timer.CivilTime;

/** The latest 1000 signalling messages. */
final class Ladder implements Trace {
    static final int MAX_ENTRIES = 1_000;

    private final CivilTime civil;
    private final Deque<Rung> rungs = new ArrayDeque<>(MAX_ENTRIES);
    private long passed;

    Ladder(CivilTime civil) {
        this.civil = civil;
    }

    @Override
    public void passed(Lifeline party, Direction direction, String name, OctetString octets) {
        if (rungs.size() == MAX_ENTRIES) {
            rungs.removeFirst();
        }
        rungs.addLast(new Rung(party, direction, civil.now(), name, octets));
        passed++;
    }

    /** Number of messages since the start. */
    long passedCount() {
        return passed;
    }

    List<LadderEntry> entries() {
        List<LadderEntry> entries = new ArrayList<>(rungs.size());
        rungs.forEach(rung -> entries.add(rung.entry()));
        return Collections.unmodifiableList(entries);
    }

    /** A message whose terminal may get its number later: the first message of a registration has none yet. */
    private static final class Rung {
        private final Lifeline party;
        private final Direction direction;
        private final Instant time;
        private final String name;
        private final boolean isCiphered;
        private final OctetString octets;
        private LadderEntry entry;
        private boolean isFinal;

        Rung(Lifeline party, Direction direction, Instant time, String name, OctetString octets) {
            this.party = party;
            this.direction = direction;
            this.time = time;
            this.name = name;
            isCiphered = party.isCiphered();
            this.octets = octets;
        }

        LadderEntry entry() {
            if (entry == null || !isFinal) {
                entry = made(party.lifeline());
                isFinal = party.hasNumber();
            }
            return entry;
        }

        private LadderEntry made(String terminal) {
            return direction == Direction.UPLINK
                    ? new LadderEntry(time, terminal, LadderEntry.CENTER, name, isCiphered, octets)
                    : new LadderEntry(time, LadderEntry.CENTER, terminal, name, isCiphered, octets);
        }
    }
}
