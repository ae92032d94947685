package simgsm.classroom.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.console.CommandException;
import simgsm.console.Event;

class ClassBoardTest {
    private final ClassBoard board = new ClassBoard();

    @BeforeEach
    void students() {
        board.add("a", "100", "200", 10, 5);
        board.add("b", "101", "201", 10, 5);
    }

    private boolean event(double seconds, String line) {
        try {
            return board.event(Event.parse(line), (long) (seconds * 1e9));
        } catch (CommandException e) {
            throw new AssertionError(e);
        }
    }

    private List<String> first() {
        return board.ranked().get(0).cells();
    }

    @Test
    void theTimeRunsFromTheFirstKeyToTheGoal() {
        event(1, "pose robot=a x=10.0 y=5.0");
        event(2, "keys robot=a keys=*");
        event(3, "keys robot=a keys=*");
        event(4, "order robot=a verdict=accepted");
        event(5, "pose robot=a x=9.0 y=5.0");
        event(6.5, "pose robot=a x=9.7 y=5.2");
        assertEquals(List.of("100", "", "200", "1", "2", "0", "4.5", "", ""), first());
    }

    private boolean told(String line) {
        try {
            return board.told(Event.parse(line));
        } catch (CommandException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void aNameFromABrowserAndOneFromAPhoneStandBesideTheirNumbers() {
        assertTrue(told("joined kind=web number=101 from=1.2.3.4 name=Ana"));
        assertFalse(told("joined kind=web number=101 from=1.2.3.4 name=Ana"));
        assertFalse(told("named number=5550300 name=Eva"));
        assertTrue(told("named number=100 name=\"Luis G.\""));
        assertEquals(
                List.of("Luis G.", "Ana"),
                board.rows().stream().map(row -> row.cells().get(1)).toList());
    }

    @Test
    void resultsOfLessonsCountThePassedStepsOfTheLatestLesson() {
        told("lesson-result number=101 lesson=tones step=low result=fail tries=1 hints=0");
        told("lesson-result number=101 lesson=tones step=low result=pass tries=2 hints=1");
        told("lesson-result number=101 lesson=tones step=high result=pass tries=1 hints=0");
        assertEquals("class number=101 name=\"\" robot=201 orders=0 collisions=0 lesson=tones score=2", row());
        told("lesson-result number=101 lesson=tones step=high result=fail tries=5 hints=1");
        told("lesson-result number=101 lesson=towns step=low result=fail tries=1 hints=0");
        assertEquals("class number=101 name=\"\" robot=201 orders=0 collisions=0 lesson=towns score=0", row());
        assertEquals(
                "tones low pass tries=2 hints=1; tones high pass tries=1 hints=0; towns low fail tries=1 hints=0",
                board.rows().get(1).steps());
        assertFalse(told("lesson-result number=99 lesson=tones step=low result=pass tries=1 hints=0"));
    }

    @Test
    void anotherRunOfALessonKeepsTheTriesAndHintsUntilTheFirstPass() {
        told("lesson-result number=100 lesson=tones step=low result=fail tries=4 hints=0");
        told("lesson-result number=100 lesson=tones step=low result=fail tries=5 hints=1");
        told("lesson-result number=100 lesson=tones step=low result=fail tries=1 hints=0");
        assertEquals("tones low fail tries=6 hints=1", board.rows().get(0).steps());
        told("lesson-result number=100 lesson=tones step=low result=pass tries=2 hints=0");
        told("lesson-result number=100 lesson=tones step=low result=fail tries=1 hints=0");
        assertEquals("tones low pass tries=7 hints=1", board.rows().get(0).steps());
    }

    @Test
    void aBrowserThatJoinsWithoutANameLeavesTheKnownOne() {
        told("named number=100 name=Ana");
        assertFalse(told("joined kind=web number=100 from=1.2.3.4"));
        assertFalse(told("joined kind=web number=100 from=1.2.3.4 name=\"\""));
        assertEquals("Ana", first().get(1));
    }

    private String row() {
        return Event.from(board.list().get(1)).toString();
    }

    @Test
    void whatComesAfterTheGoalDoesNotCount() {
        event(1, "keys robot=a keys=*");
        event(2, "pose robot=a x=10 y=5");
        assertFalse(event(3, "status robot=a value=Collision"));
        assertEquals("0", first().get(5));
    }

    @Test
    void resultsWithKeysStandBeforeAbsentStudents() {
        board.start(0);
        event(1, "keys robot=b keys=5");
        event(2, "status robot=b value=Collision");
        assertEquals("101", first().get(0));
        board.start(3_000_000_000L);
        assertEquals("100", first().get(0));
        event(4, "sms robot=b from=101 text=x");
        assertEquals("101", first().get(0));
    }

    @Test
    void theFasterOneIsFirstThenTheOneWithFewerCollisions() {
        event(1, "status robot=a value=Collision");
        assertEquals("101", first().get(0));
        event(2, "sms robot=a from=100 text=x");
        event(9, "pose robot=a x=10 y=5");
        assertEquals("100", first().get(0));
        event(3, "keys robot=b keys=5");
        event(5, "pose robot=b x=10 y=5");
        assertEquals("101", first().get(0));
    }

    @Test
    void aChallengeSetsResultsBackAndItsTimeRunsForAllUntilItIsStopped() {
        event(1, "keys robot=a keys=*");
        event(2, "pose robot=a x=10 y=5");
        assertEquals(0, board.seconds(3_000_000_000L));
        assertTrue(board.rows().get(0).isBest());

        board.start(10_000_000_000L);
        assertEquals(List.of("100", "", "200", "0", "0", "0", "", "", ""), first());
        assertFalse(board.rows().get(0).isBest());
        event(12, "keys robot=b keys=*");
        event(13, "pose robot=b x=10 y=5");
        assertEquals(List.of("101", "", "201", "0", "1", "0", "3.0", "", ""), first());
        assertEquals(3, board.seconds(13_900_000_000L));

        board.stop(14_000_000_000L);
        assertFalse(event(15, "keys robot=a keys=*"));
        assertEquals(4, board.seconds(99_000_000_000L));
        assertEquals(10_000_000_000L, board.beganNanos("100").getAsLong());
    }

    @Test
    void otherEventsAndRobotsChangeNothing() {
        assertFalse(event(1, "tone robot=a key=1"));
        assertFalse(event(1, "keys robot=c keys=1"));
        assertTrue(event(1, "order robot=a verdict=invalid"));
        assertEquals("0", first().get(3));
    }
}
