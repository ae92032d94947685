package simrobot.behaviour;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The wanderer's rule, decision by decision. */
class WanderTest {
    private static final Steering AHEAD = new Steering(0.4, 0);

    private static SonarRanges clear() {
        return sonar -> 5;
    }

    private static SonarRanges echo(int which, double meters) {
        return sonar -> sonar == which ? meters : 5;
    }

    @Test
    void aClearWayIsGoneAtFortyCentimetersASecond() {
        assertEquals(AHEAD, new Wander(0).decide(clear(), false));
    }

    @ParameterizedTest
    @CsvSource({"0,0.1,false", "1,0.499,true", "1,0.5,false", "6,0.499,true", "7,0.1,false", "11,0.1,false"})
    void onlySonarsOneToSixWithinHalfAMeterTurnIt(int sonar, double meters, boolean turns) {
        assertEquals(turns, new Wander(0).decide(echo(sonar, meters), false).radiansPerSecond() != 0);
    }

    @Test
    void itTurnsForTenTicksFromTheOneItBeganWhateverItHears() {
        Wander wander = new Wander(0);
        Steering left = new Steering(0, Math.toRadians(50));
        assertEquals(left, wander.decide(echo(3, 0.4), false));
        for (int tick = 2; tick <= 10; tick++) {
            assertEquals(left, wander.decide(clear(), false), "tick " + tick);
        }
        assertEquals(AHEAD, wander.decide(clear(), false));
    }

    @Test
    void oddRobotsTurnToTheRight() {
        assertEquals(new Steering(0, -Math.toRadians(50)), new Wander(7).decide(echo(2, 0.2), false));
    }

    @Test
    void whoIsHeldByWhatNoSonarHearsTurnsToo() {
        assertEquals(new Steering(0, Math.toRadians(50)), new Wander(0).decide(clear(), true));
    }
}
