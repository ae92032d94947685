package simgsm.center.records;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import simgsm.air.Cause;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;

/** Makes a record of each cleared call and of each ended message. Owned by the exchange's thread. */
public final class DetailRecords implements Consumer<ExchangeEvent> {
    private final InstantSource clock;
    /** Counts a call's seconds, because the civil clock may be set during it. */
    private final LongSupplier nanos;

    private final Consumer<DetailRecord> writer;
    private final Map<Long, Course> calls = new HashMap<>();

    /** The times of a running call. */
    private static final class Course {
        final Instant began;
        Optional<Instant> answered = Optional.empty();
        long answeredNanos;

        Course(Instant began) {
            this.began = began;
        }
    }

    DetailRecords(InstantSource clock, LongSupplier nanos, Consumer<DetailRecord> writer) {
        this.clock = clock;
        this.nanos = nanos;
        this.writer = writer;
    }

    /** Records that go to files. @param nanos the exchange's time */
    public DetailRecords(LongSupplier nanos, RecordFiles files) {
        this(InstantSource.system(), nanos, files::add);
    }

    @Override
    public void accept(ExchangeEvent event) {
        if (event instanceof ExchangeEvent.CallChanged call) {
            Course course = calls.computeIfAbsent(call.id(), id -> new Course(clock.instant()));
            switch (call.state()) {
                case ACTIVE -> {
                    course.answered = Optional.of(clock.instant());
                    course.answeredNanos = nanos.getAsLong();
                }
                case RELEASED -> ended(call, course);
                default -> {}
            }
        }
    }

    private void ended(ExchangeEvent.CallChanged call, Course course) {
        calls.remove(call.id());
        writer.accept(new DetailRecord(
                DetailRecord.Type.CALL,
                call.id(),
                call.from().digits(),
                call.to().digits(),
                "",
                course.began,
                course.answered,
                clock.instant(),
                Duration.ofNanos(course.answered.isPresent() ? nanos.getAsLong() - course.answeredNanos : 0),
                course.answered.isPresent() ? "answered" : "refused",
                call.cause().map(Cause::code)));
    }

    /** Handles a message's change of state. */
    public void accept(ShortMessage message, MessageState state) {
        if (state != MessageState.ACCEPTED) {
            Instant now = clock.instant();
            Duration waited = Duration.between(message.acceptedAt(), now);
            writer.accept(new DetailRecord(
                    DetailRecord.Type.MESSAGE,
                    message.id(),
                    message.sender().value(),
                    message.to().digits(),
                    message.esme().map(EsmeOrigin::systemId).orElse(""),
                    message.acceptedAt(),
                    Optional.empty(),
                    now,
                    waited.isNegative() ? Duration.ZERO : waited,
                    state.name().toLowerCase(Locale.ROOT),
                    Optional.empty()));
        }
    }
}
