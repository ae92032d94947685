package simgsm.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigDecimal;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EventFormTest {
    public enum Light {
        RED,
        GREEN
    }

    public record Code(int code) implements EventValue {
        @Override
        public Object eventValue() {
            return code;
        }

        public String title() {
            return "title " + code;
        }
    }

    @EventLine("passed by= light= cause= title=cause.title [lane=] [next=after.title] at=")
    public record Passed(String by, Light light, Code cause, OptionalInt lane, Optional<Code> after, Instant at) {}

    @EventLine("moved robot= x=metres:2 parts=")
    public record Moved(double metres, List<Light> parts) {}

    private static final Instant NOON = Instant.parse("2026-01-02T12:00:00.750Z");

    private static String texts(Object event, Map<String, ?> given) {
        StringBuilder texts =
                new StringBuilder(EventForm.of(event).orElseThrow().name());
        EventForm.of(event)
                .orElseThrow()
                .values(event, given)
                .forEach((key, value) ->
                        texts.append(' ').append(key).append('=').append(EventForm.text(value)));
        return texts.toString();
    }

    @Test
    void fieldsAreInTheOrderOfTheLineWithWordsCodesAndWholeSeconds() {
        assertEquals(
                "passed by=me light=green cause=7 title=title 7 lane=3 next=title 8 at=2026-01-02T12:00:00Z",
                texts(
                        new Passed("me", Light.GREEN, new Code(7), OptionalInt.of(3), Optional.of(new Code(8)), NOON),
                        Map.of()));
    }

    @Test
    void aFieldInBracketsIsLeftOutWhileItIsEmpty() {
        assertEquals(
                "passed by=me light=red cause=7 title=title 7 at=2026-01-02T12:00:00Z",
                texts(new Passed("me", Light.RED, new Code(7), OptionalInt.empty(), Optional.empty(), NOON), Map.of()));
    }

    @ParameterizedTest
    @CsvSource({"1.375, 1.38", "-0.001, 0.00", "12, 12.00", "-3.456, -3.46"})
    void numbersAreRoundedAndZeroHasNoSign(double metres, BigDecimal rounded) {
        Moved moved = new Moved(metres, List.of(Light.RED, Light.GREEN));
        assertEquals(
                Map.of("robot", "anna", "x", rounded, "parts", moved.parts()),
                EventForm.of(moved).orElseThrow().values(moved, Map.of("robot", "anna")));
        assertEquals("moved robot=anna x=" + rounded + " parts=red,green", texts(moved, Map.of("robot", "anna")));
    }

    @Test
    void aValueThatNeitherEventNorPrinterHasIsRefused() {
        Moved moved = new Moved(1, List.of());
        assertThrows(IllegalArgumentException.class, () -> texts(moved, Map.of()));
    }

    @Test
    void aRecordWithoutALineHasNoForm() {
        assertEquals(Optional.empty(), EventForm.of(new Code(1)));
    }

    @ParameterizedTest
    @CsvSource({"moved x=meters", "moved x=metres.feet", "moved x:2"})
    void aLineThatDoesNotFitItsClassIsRefused(String line) {
        assertThrows(IllegalArgumentException.class, () -> EventForm.of(Moved.class, line));
    }
}
