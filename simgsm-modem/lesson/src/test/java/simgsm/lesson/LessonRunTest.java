package simgsm.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.console.Event;

class LessonRunTest {
    private static final String PROGRAMS =
            "\nprogram phone simgsm-phone\nprogram robot simrobot\nprogram p simgsm-cells\n";

    private static LessonRun run(String... lines) throws LessonException {
        return run(1, lines);
    }

    private static LessonRun run(long seed, String... lines) throws LessonException {
        Lesson lesson =
                LessonReader.read("sample", "sample/lesson.txt", "minutes 5\n" + String.join("\n", lines) + PROGRAMS);
        return new LessonRun(lesson, seed, (function, arguments) -> function + String.join("", arguments));
    }

    private static void event(LessonRun run, String source, String line) {
        try {
            run.event(source, Event.parse(line));
        } catch (simgsm.console.CommandException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void aStepIsDoneWhenTheEventWithItsFieldsHasCome() throws Exception {
        LessonRun run = run("step a", "when phone tone key=3");
        event(run, "robot", "tone key=3");
        event(run, "phone", "tone key=4");
        assertFalse(run.isDone("a"));
        event(run, "phone", "tone key=3 meaning=done");
        assertTrue(run.isDone("a"));
        assertEquals(1, run.score());
    }

    @Test
    void aChainNeedsItsEventsInOrder() throws Exception {
        LessonRun run = run("step a", "when phone tone key=6", "then phone tone key=3");
        event(run, "phone", "tone key=3");
        event(run, "phone", "tone key=6");
        assertFalse(run.isDone("a"));
        event(run, "phone", "tone key=3");
        assertTrue(run.isDone("a"));
    }

    @Test
    void aStepBehindAnotherCountsOnlyWhatComesAfterIt() throws Exception {
        LessonRun run = run("step a", "when p x", "step b", "after a", "when p y");
        event(run, "p", "y");
        event(run, "p", "x");
        assertFalse(run.isDone("b"));
        event(run, "p", "y");
        assertTrue(run.isDone("b"));
    }

    @Test
    void aLimitIsLostWithOneEventTooMany() throws Exception {
        LessonRun run = run("step a", "when p end", "at-most 1 p order");
        event(run, "p", "order");
        assertFalse(run.isExceeded("a"));
        event(run, "p", "order");
        event(run, "p", "end");
        assertFalse(run.isDone("a"));
        assertTrue(run.isExceeded("a"));
    }

    @Test
    void eachValueOfADifferentFieldCountsOnce() throws Exception {
        LessonRun run = run("step a", "again p new", "at-least 2 different key phone tone meaning=done");
        event(run, "phone", "tone key=3 meaning=done");
        event(run, "phone", "tone key=3 meaning=done");
        event(run, "phone", "tone key=4");
        assertFalse(run.isDone("a"));
        event(run, "p", "new");
        event(run, "phone", "tone key=4 meaning=done");
        assertFalse(run.isDone("a"));
        event(run, "phone", "tone key=3 meaning=done");
        assertTrue(run.isDone("a"));
    }

    @Test
    void aStepThatIsDoneStaysDone() throws Exception {
        LessonRun run = run("step a", "when p end", "at-most 1 p order");
        event(run, "p", "order");
        event(run, "p", "end");
        event(run, "p", "order");
        assertTrue(run.isDone("a"));
        assertFalse(run.isExceeded("a"));
    }

    @Test
    void aNewTryBeginsCountingAtZero() throws Exception {
        LessonRun run = run("step a", "again p start", "when p end", "at-most 1 p order");
        event(run, "p", "start");
        event(run, "p", "order");
        event(run, "p", "order");
        event(run, "p", "end");
        assertFalse(run.isDone("a"));
        assertTrue(run.isExceeded("a"));
        event(run, "p", "start");
        event(run, "p", "order");
        assertFalse(run.isDone("a"));
        event(run, "p", "end");
        assertTrue(run.isDone("a"));
    }

    @Test
    void eachOfSeveralEventsBeginsANewTry() throws Exception {
        LessonRun run = run("step a", "again phone sent", "again robot sms", "when p file", "then p end");
        event(run, "p", "file");
        event(run, "phone", "sent keys=1");
        event(run, "p", "end");
        event(run, "p", "file");
        event(run, "robot", "sms text=1");
        event(run, "p", "end");
        assertFalse(run.isDone("a"));
        event(run, "p", "file");
        event(run, "p", "end");
        assertEquals(new StepResult("sample", "a", true, 3, 0), run.result("a"));
    }

    @Test
    void aKeptValueIsTestedWhenTheEventComes() throws Exception {
        LessonRun run =
                run("keep cell cell p camped", "keep cell to p handover", "step a", "when robot order {cell}=east");
        event(run, "robot", "order cell=east");
        event(run, "p", "camped cell=west");
        event(run, "robot", "order");
        event(run, "p", "handover to=east");
        event(run, "p", "camped cell=west");
        event(run, "robot", "order");
        assertFalse(run.isDone("a"));
        event(run, "p", "handover to=east");
        event(run, "robot", "order");
        assertTrue(run.isDone("a"));
    }

    @Test
    void theNameOfAValueThatIsNotKnownYetIsNoAnswer() throws Exception {
        LessonRun run = run("keep x n p event", "step a", "answer q", "when student q text={x}");
        run.answer("q", "{x}");
        assertFalse(run.isDone("a"));
        event(run, "p", "event n=5");
        run.answer("q", "{x}");
        assertFalse(run.isDone("a"));
        run.answer("q", "5");
        assertTrue(run.isDone("a"));
    }

    @Test
    void triesAndHintsAreToldWithEachAnswerAndEachStepThatIsDone() throws Exception {
        LessonRun run = run("step a", "answer q", "when student q n1=5", "step b", "when p end");
        List<StepResult> told = new ArrayList<>();
        run.listen(told::add);
        run.answer("q", "4");
        run.hint("a");
        run.hint("a");
        run.answer("q", "5");
        run.answer("q", "6");
        run.hint("a");
        event(run, "p", "end");
        run.hint("b");
        assertEquals(
                List.of(
                        new StepResult("sample", "a", false, 1, 0),
                        new StepResult("sample", "a", true, 2, 1),
                        new StepResult("sample", "b", true, 1, 0)),
                told);
        assertEquals(told.subList(1, 3), List.of(run.result("a"), run.result("b")));
    }

    @Test
    void whatIsCountedIsShownWhereMoreThanOneIsWantedOrAllowed() throws Exception {
        LessonRun run = run("step a", "at-least 3 p x", "at-most 2 p y", "at-most 0 p z", "when p end");
        event(run, "p", "x");
        assertEquals(List.of("1/3", "0/2"), run.counts("a"));
    }

    @Test
    void atLeastCountsEvents() throws Exception {
        LessonRun run = run("step a", "at-least 2 p order verdict=accepted");
        event(run, "p", "order verdict=accepted");
        event(run, "p", "order verdict=refused");
        assertFalse(run.isDone("a"));
        event(run, "p", "order verdict=accepted");
        assertTrue(run.isDone("a"));
    }

    @Test
    void anAnswersNumbersAreComparedWithinTheirTolerance() throws Exception {
        LessonRun run = run("step a", "answer f", "when student f n1=697+-1.5% n2=1209+-2 count=2");
        run.answer("f", "697 1212");
        assertFalse(run.isDone("a"));
        run.answer("f", "697, 1210.5");
        assertTrue(run.isDone("a"));
        assertEquals("697, 1210.5", run.answers().get("f"));
    }

    @Test
    void theFirstPredictionAndARightAnswerStay() throws Exception {
        LessonRun run = run("step a", "answer f", "when student f n1=2");
        run.predict(" five ");
        run.predict("six");
        assertEquals("five", run.prediction());
        run.answer("f", "1");
        run.answer("f", "2");
        run.answer("f", "3");
        assertEquals("2", run.answers().get("f"));
    }

    @Test
    void aPartOfATextAndAlternativesAreCompared() throws Exception {
        LessonRun run = run("step a", "when phone sms text~\"is done\" from=1|2");
        event(run, "phone", "sms from=3 text=\"It is  done.\"");
        assertFalse(run.isDone("a"));
        event(run, "phone", "sms from=2 text=\"It IS  done.\"");
        assertTrue(run.isDone("a"));
    }

    @Test
    void numbersAreComparedAndWhatIsNoneFails() throws Exception {
        LessonRun run = run("step a", "when robot pose x>=1.5 y<0");
        event(run, "robot", "pose x=abc y=-1");
        event(run, "robot", "pose x=1.4 y=-1");
        event(run, "robot", "pose y=-1");
        assertFalse(run.isDone("a"));
        event(run, "robot", "pose x=1.5 y=-0.1");
        assertTrue(run.isDone("a"));
    }

    @Test
    void drawnValuesFollowFromTheSeedAndDiffer() throws Exception {
        String draw = "draw a b c from 1 2 3";
        LessonRun run = run(7, draw, "step s", "when p x");
        assertEquals(run(7, draw, "step s", "when p x").shown("{a}{b}{c}"), run.shown("{a}{b}{c}"));
        assertEquals(3, run.shown("{a}{b}{c}").chars().distinct().count());
    }

    @Test
    void computedAndKeptValuesAreShownOnlyInTheLessonsOwnSolutions() throws Exception {
        LessonRun run = run("keep x n p event", "let y low {x}", "step s", "answer q", "when student q text={y}");
        assertEquals("{y}", run.solved("{y}"));
        event(run, "p", "event n=5");
        assertEquals("low5 {x}", run.solved("{y}") + " " + run.shown("{x}"));
        run.answer("q", "LOW 5");
        assertTrue(run.isDone("s"));
    }

    @Test
    void aFaultInALessonIsReportedWithItsLine() {
        String text = assertThrows(LessonException.class, () -> run("step a", "when phone"))
                .getMessage();
        assertEquals("sample/lesson.txt, line 3: expected SOURCE EVENT [FIELD=VALUE]..., found phone", text);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '!',
            value = {
                "when phone tone ! line 2: expected step NAME before the first condition",
                "step a ! line 5: expected at least one condition for step a",
                "step a;after b;when p x ! line 3: expected a step above, found b",
                "draw a b from 1;step s;when p x ! line 2: expected at least 2 values to draw from, found 1",
                "wenn p x ! line 2: expected one of minutes, centre, program, later",
                "program q simgsm-center;step s;when p x ! line 2: expected one of simgsm-phone, simrobot, simgsm-cells; found simgsm-center",
                "program phone simrobot;step s;when p x ! line 5: expected a program's name once; found phone",
                "program act simrobot;step s;when p x ! line 2: expected another name for a program; found act",
                "step s;when p x;step s;when p y ! line 4: expected a step's name once; found s",
                "step s;when fone x ! line 3: expected a source of centre, p, phone, robot, student, tool, trace; found fone",
                "step s;answer a;when student b n1=2 ! line 4: expected an answer of a; found b",
                "answer a;step s;when p x ! line 2: expected step NAME before it; found none",
                "draw k from 1 2;step s;when p x n={j} ! line 4: expected in braces one of folder, k, lesson; found j",
                "let x sum 1 2;step s;when p x ! line 2: expected a function of half-heard, high, low",
                "let x low;step s;when p x ! line 2: expected low with 1 arguments; found 0",
                "action a;do act a;step s;when p x ! line 3: expected a line that is no action itself; found act a",
                "closed 55x;step s;when p x ! line 2: expected numbers of 1 to 15 digits; found 55x",
                "action a;action a;step s;when p x ! line 3: expected an action's name once; found a"
            })
    void eachFaultIsNamedWithItsLine(String lines, String expected) {
        String text =
                assertThrows(LessonException.class, () -> run(lines.split(";"))).getMessage();
        assertTrue(text.startsWith("sample/lesson.txt, " + expected), text);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "852 1209",
                "852, 1209",
                "852,1209",
                "852 Hz y 1209 Hz",
                "852Hz and 1209Hz",
                "852/1209",
                "852 + 1209.",
                "low: 852; high: 1209"
            })
    void unitsAndConjunctionsMayStandBetweenTheNumbersOfAnAnswer(String typed) throws Exception {
        LessonRun run = run("step a", "answer a", "when student a n1=852+-1.5% n2=1209+-1.5% count=2");
        run.answer("a", typed);
        assertTrue(run.isDone("a"), typed);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"-9.5", "-9,5 dB", "\u22129,5", "about -9.5dB"})
    void aNumberMayHaveACommaAndAUnit(String typed) throws Exception {
        LessonRun run = run("step a", "answer a", "when student a n1=-9.5 | -9,5".replace(" | ", "|"));
        run.answer("a", typed);
        assertTrue(run.isDone("a"), typed);
    }

    @Test
    void anAnswerWithoutNumbersHasItsWords() throws Exception {
        LessonRun run = run("step a", "answer a", "when student a n1=west n2=east count=2");
        run.answer("a", "west, east");
        assertTrue(run.isDone("a"));
    }

    @Test
    void anActionTakesANumberOfItsRange() throws Exception {
        LessonRun run = run(
                "action any number -20..60",
                "do tool x {input}",
                "action whole integer 0..40",
                "do tool x {input}",
                "action wave file wav",
                "do give {input}",
                "step a",
                "when p x");
        LessonAction.Range any =
                (LessonAction.Range) run.lesson().action("any").orElseThrow().input();
        assertEquals(Optional.of("-5.5"), any.number(" -5,5 dB"));
        assertEquals(Optional.of("60"), any.number("60"));
        for (String same : List.of("8", "8.0", "08,00", "8 dB")) {
            assertEquals(Optional.of("8"), any.number(same), same);
        }
        for (String wrong : List.of("60.1", "-21", "abc", "", "1e1", "NaN", "--5", "5 5".replace(" ", "x"))) {
            assertEquals(Optional.empty(), any.number(wrong), wrong);
        }
        LessonAction.Range whole =
                (LessonAction.Range) run.lesson().action("whole").orElseThrow().input();
        assertEquals(Optional.of("40"), whole.number("40"));
        assertEquals(Optional.empty(), whole.number("15,5"));
        assertEquals(Optional.empty(), whole.number("50"));
        assertEquals(
                new LessonAction.File("wav"),
                run.lesson().action("wave").orElseThrow().input());
    }

    @ParameterizedTest
    @ValueSource(strings = {"action a number", "action a number 5..5", "action a word", "action a file w.v", "action"})
    void anActionWithAnotherInputIsRefused(String line) {
        assertThrows(LessonException.class, () -> run(line, "do tool x", "step a", "when p x"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0345", "03 45", "0x03 0x45", "03:45", "0x0345", "0X03 0x45"})
    void octetsMayBeWrittenAsWiresharkShowsThem(String typed) throws Exception {
        LessonRun run = run("step a", "answer a", "when student a text=0345");
        run.answer("a", typed);
        assertTrue(run.isDone("a"), typed);
        assertEquals(typed, run.answers().get("a"));
    }
}
