package simrobot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** The wanderer's rule, decision by decision. */
class WanderTest {
    private static final Steering AHEAD = new Steering(0.4, 0);

    private static Senses clear() {
        return new FixedSenses();
    }

    private static Senses echo(int which, double meters) {
        return new FixedSenses().sonar(which, meters);
    }

    @Test
    void aClearWayIsGoneAtFortyCentimetersASecond() {
        assertEquals(AHEAD, new Wander(0).decide(clear()));
    }

    @ParameterizedTest
    @CsvSource({"0,0.1,false", "1,0.499,true", "1,0.5,false", "6,0.499,true", "7,0.1,false", "11,0.1,false"})
    void onlySonarsOneToSixWithinHalfAMeterTurnIt(int sonar, double meters, boolean turns) {
        assertEquals(turns, new Wander(0).decide(echo(sonar, meters)).radiansPerSecond() != 0);
    }

    @Test
    void itTurnsForTenTicksFromTheOneItBeganWhateverItHears() {
        Wander wander = new Wander(0);
        Steering left = new Steering(0, Math.toRadians(50));
        assertEquals(left, wander.decide(echo(3, 0.4)));
        for (int tick = 2; tick <= 10; tick++) {
            assertEquals(left, wander.decide(clear()), "tick " + tick);
        }
        assertEquals(AHEAD, wander.decide(clear()));
    }

    @Test
    void oddRobotsTurnToTheRight() {
        assertEquals(new Steering(0, -Math.toRadians(50)), new Wander(7).decide(echo(2, 0.2)));
    }

    @Test
    void whoIsHeldByWhatNoSonarHearsTurnsToo() {
        assertEquals(new Steering(0, Math.toRadians(50)), new Wander(0).decide(new FixedSenses().blocked()));
    }
}
