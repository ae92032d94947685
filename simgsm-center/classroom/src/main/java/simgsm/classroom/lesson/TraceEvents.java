package simgsm.classroom.lesson;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.LadderEntry;
import simgsm.console.Event;

/**
 * The signalling messages of the centre's ladder as events {@code message name= from= to= octets=}. The messages of a
 * registration wait until its terminal is named by its number, at most until the channel's release or 3 s.
 */
final class TraceEvents implements Consumer<ExchangeSnapshot> {
    private static final Duration LONGEST_REGISTRATION = Duration.ofSeconds(3);
    private static final String LAST_MESSAGE = "Channel Release";

    private final Consumer<Event> out;
    private long shown;

    TraceEvents(Consumer<Event> out) {
        this.out = out;
    }

    @Override
    public void accept(ExchangeSnapshot newest) {
        List<LadderEntry> ladder = newest.ladder();
        int fresh = (int) Math.min(newest.ladderCount() - shown, ladder.size());
        List<LadderEntry> left = ladder.subList(ladder.size() - fresh, ladder.size());
        shown = newest.ladderCount();
        for (int i = 0; i < left.size(); i++) {
            LadderEntry entry = left.get(i);
            boolean isYoung = entry.time().plus(LONGEST_REGISTRATION).isAfter(newest.time());
            if (isYoung && unnamed(entry).anyMatch(address -> !isReleased(address, left))) {
                shown -= left.size() - i;
                return;
            }
            out.accept(Event.of("message")
                    .with("name", entry.name())
                    .with("from", entry.from())
                    .with("to", entry.to())
                    .with("octets", entry.octets()));
        }
    }

    /** The addresses of terminals without a number. */
    private static Stream<String> unnamed(LadderEntry entry) {
        return Stream.of(entry.from(), entry.to()).filter(end -> end.contains(":"));
    }

    private static boolean isReleased(String address, List<LadderEntry> messages) {
        return messages.stream()
                .anyMatch(
                        entry -> entry.name().equals(LAST_MESSAGE) && entry.to().equals(address));
    }
}
