package simgsm.classroom.lesson;

import java.util.List;
import java.util.function.Consumer;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.LadderEntry;
import simgsm.console.Event;

/** The signalling messages of the centre's ladder as events {@code message name= from= to= octets=}. */
final class TraceEvents implements Consumer<ExchangeSnapshot> {
    private final Consumer<Event> out;
    private long shown;

    TraceEvents(Consumer<Event> out) {
        this.out = out;
    }

    @Override
    public void accept(ExchangeSnapshot newest) {
        List<LadderEntry> ladder = newest.ladder();
        int fresh = (int) Math.min(newest.ladderCount() - shown, ladder.size());
        shown = newest.ladderCount();
        for (LadderEntry entry : ladder.subList(ladder.size() - fresh, ladder.size())) {
            out.accept(Event.of("message")
                    .with("name", entry.name())
                    .with("from", entry.from())
                    .with("to", entry.to())
                    .with("octets", entry.octets()));
        }
    }
}
