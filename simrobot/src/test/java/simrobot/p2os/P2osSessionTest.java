package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.BehaviourKind;
import vericommand.RobotStatus;

class P2osSessionTest {
    // ---- handshake -------------------------------------------------------------------------------------------------

    @Test
    void theHandshakeEchoesTwiceAndThenIntroducesTheRobot() {
        SessionBench bench = new SessionBench();
        bench.say(0).say(1).say(2);
        assertArrayEquals(new byte[] {0}, bench.heard.get(0));
        assertArrayEquals(new byte[] {1}, bench.heard.get(1));
        assertEquals("\2robot\0Pioneer\0p3dx\0", new String(bench.heard.get(2), StandardCharsets.US_ASCII));
        assertEquals(3, bench.heard.size());
    }

    @Test
    void aHandshakeMayBeginAgainAtAnyPoint() {
        SessionBench bench = new SessionBench();
        bench.say(0)
                .say(0)
                .say(1)
                .say(0)
                .say(1)
                .say(2)
                .say(2)
                .say(0)
                .say(1)
                .say(2)
                .say(1);
        assertEquals(1, bench.sips().size());
        assertEquals(11, bench.heard.size());
    }

    @Test
    void aSyncThatIsRepeatedInOneReadIsAnsweredOnce() {
        SessionBench bench = new SessionBench();
        bench.say(new byte[] {
            (byte) 0xFA,
            (byte) 0xFB,
            3,
            0,
            0,
            0,
            (byte) 0xFA,
            (byte) 0xFB,
            3,
            0,
            0,
            0,
            (byte) 0xFA,
            (byte) 0xFB,
            3,
            1,
            0,
            1
        });
        assertArrayEquals(new byte[] {0}, bench.heard.get(0));
        assertArrayEquals(new byte[] {1}, bench.heard.get(1));
        assertEquals(2, bench.heard.size());
    }

    /** As ARIA: each step is sent, then the first unread answer counts; 255 empties the line, any other wrong one restarts. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 7})
    void aClientThatRepeatedSyncBeforeLateAnswersGetsInStep(int late) {
        SessionBench bench = new SessionBench();
        for (int i = 0; i < late; i++) {
            bench.say(P2osCommandNumber.PULSE);
        }
        int step = 0;
        for (int tries = 0; step < 3 && tries < 50; tries++) {
            boolean waits = bench.heard.isEmpty();
            if (waits) {
                bench.say(step);
            }
            int id = bench.heard.isEmpty() ? -1 : bench.heard.remove(0)[0] & 0xFF;
            if (id == P2osCommandNumber.OUT_OF_ORDER) {
                bench.heard.clear();
            }
            int sent = step;
            step = id == step ? step + 1 : 0;
            if (!waits) {
                bench.say(sent);
            }
        }
        assertEquals(3, step);
    }

    @Test
    void twoPulsesInOneReadOfAnOpenSessionChangeNothing() {
        SessionBench bench = SessionBench.opened();
        bench.robot.autonomy().begin(BehaviourKind.WANDER);
        bench.say(new byte[] {(byte) 0xFA, (byte) 0xFB, 3, 0, 0, 0, (byte) 0xFA, (byte) 0xFB, 3, 0, 0, 0});
        assertTrue(bench.robot.autonomy().isActive());
    }

    @Test
    void nothingIsSentBeforeTheSessionIsOpen() {
        SessionBench bench = new SessionBench();
        bench.say(0).say(1).say(2).heard.clear();
        bench.say(P2osCommandNumber.VEL, 200).say(P2osCommandNumber.CONFIG).seconds(1);
        assertEquals(1 + 1, bench.heard.size(), "only the two pulses are echoed");
        assertEquals(0, bench.robot.xMeters());
    }

    @Test
    void playersOpenWithoutArgumentOpensToo() {
        SessionBench bench = new SessionBench();
        bench.say(0).say(1).say(2).say(1).seconds(1);
        assertEquals(11, bench.sips().size());
    }

    @Test
    void openingDoesNotTouchTheMotors() {
        SessionBench bench = new SessionBench();
        bench.robot.setMotors(false);
        bench.open();
        assertFalse(bench.sip().motors());
        bench.say(P2osCommandNumber.MOVE, 500).seconds(3);
        assertEquals(0, bench.robot.xMeters());
        bench.say(P2osCommandNumber.ENABLE, 1).seconds(0.1);
        assertTrue(bench.sip().motors());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        bench.say(P2osCommandNumber.ENABLE, 0).seconds(0.1);
        assertEquals(RobotStatus.NO_MOTORS, bench.robot.status());
    }

    @Test
    void closeStopsTheRobotAndEndsTheConnection() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.VEL, 200).seconds(1).say(P2osCommandNumber.CLOSE);
        assertTrue(bench.closed);
        int told = bench.heard.size();
        bench.seconds(2).say(P2osCommandNumber.VEL, 200).seconds(1);
        assertEquals(told, bench.heard.size());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(0.2 * 0.2 / 0.6, bench.robot.xMeters() - 0.2 * (1 - 0.2 / 0.6), 1e-9);
    }

    @Test
    void aLostClientStopsTheRobot() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.VEL, 200).seconds(1);
        bench.session.lost();
        bench.seconds(2);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(0, bench.robot.speedMetersPerSecond());
    }

    @Test
    void aRobotThatIsSwitchedOffHangsUp() {
        SessionBench bench = SessionBench.opened();
        bench.robot.setPower(false);
        bench.seconds(0.01);
        assertTrue(bench.closed);
    }

    // ---- information packets ---------------------------------------------------------------------------------------

    @Test
    void theFirstPacketAfterOpenHasAllSonarsAndSoHasTheFirstAfterSonarOn() {
        SessionBench bench = SessionBench.opened();
        assertEquals(16, bench.sip().sonars().size());
        assertEquals(1000 - 166, bench.sip().sonars().get(3), 30);
        bench.say(P2osCommandNumber.SONAR, 0).seconds(0.1);
        assertEquals(0, bench.sip().sonars().size());
        assertEquals(0, bench.sip().flags() & 0x1E);
        bench.heard.clear();
        bench.say(P2osCommandNumber.SONAR, 1).seconds(0.1);
        assertEquals(16, bench.sips().get(0).sonars().size());
        assertEquals(0x1E, bench.sip().flags() & 0x1E);
    }

    @Test
    void onlyThePolledSonarsAreFired() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommand.packet(P2osCommandNumber.POLLING, new byte[] {4, 1}))
                .seconds(0.1);
        assertEquals(List.of(0, 3), new ArrayList<>(bench.sip().sonars().keySet()));
        bench.say(P2osCommand.packet(P2osCommandNumber.POLLING, new byte[0])).seconds(0.1);
        assertEquals(16, bench.sip().sonars().size());
    }

    @ParameterizedTest
    @CsvSource({
        "1, 10, 101",
        // a fast simulation: as many in its own time, while that is at most one each 10 ms of real time
        "10, 10, 101",
        "100, 10, 11",
        // a slow one: one each 200 ms of real time
        "0.1, 10, 501"
    })
    void informationComesEvery100MillisecondsOfSimulatedTimeWithinBounds(
            double speed, double simulatedSeconds, int expected) {
        SessionBench bench = SessionBench.opened();
        bench.seconds(simulatedSeconds, speed);
        assertEquals(expected, bench.sips().size(), 1);
    }

    @Test
    void aPausedSimulationStillTellsItsClient() {
        SessionBench bench = SessionBench.opened();
        int before = bench.sips().size();
        for (int i = 0; i < 20; i++) {
            bench.nanos += 50_000_000;
            bench.session.tick(bench.simulation.timeNanos(), bench.nanos);
        }
        assertEquals(before + 5, bench.sips().size());
    }

    @Test
    void theConfigurationSaysWhatItIs() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.CONFIG);
        String text = new String(bench.packets(0x20).get(0), StandardCharsets.ISO_8859_1);
        assertTrue(text.startsWith(" Pioneer\0p3dx\0SIM\0"), text);
        ByteBuffer in = ByteBuffer.wrap(bench.packets(0x20).get(0)).order(ByteOrder.LITTLE_ENDIAN);
        int limits = 1 + 8 + 5 + 4 + 1;
        assertEquals(500, in.getShort(limits));
        assertEquals(2200, in.getShort(limits + 2));
        assertEquals(1, bench.packets(0x20).size());
    }

    @Test
    void encodersAreSentOnceOrAlwaysOrNot() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.ENCODER, 1).seconds(0.5);
        assertEquals(1, bench.packets(0x90).size());
        bench.say(P2osCommandNumber.ENCODER, 2).say(P2osCommandNumber.MOVE, 500).seconds(3);
        assertEquals(31, bench.packets(0x90).size());
        ByteBuffer in = ByteBuffer.wrap(bench.packets(0x90).get(30)).order(ByteOrder.LITTLE_ENDIAN);
        assertEquals(500 * P3dxScale.TICKS_PER_MILLIMETER, in.getInt(1));
        assertEquals(500 * P3dxScale.TICKS_PER_MILLIMETER, in.getInt(5));
        bench.say(P2osCommandNumber.ENCODER, 0).seconds(1);
        assertEquals(31, bench.packets(0x90).size());
    }

    @Test
    void theSimulatorsStatusHasTheTruePose() {
        SessionBench bench = SessionBench.opened();
        bench.robot.place(0.25, -0.5, Math.toRadians(90));
        bench.say(P2osCommandNumber.SIM_STAT, 1).seconds(0.1);
        ByteBuffer in = ByteBuffer.wrap(bench.packets(0x62).get(0)).order(ByteOrder.LITTLE_ENDIAN);
        int pose = 1 + 2 + 4 + 3 * 2;
        assertEquals(250, in.getInt(pose));
        assertEquals(-500, in.getInt(pose + 4));
        assertEquals(90, in.getInt(pose + 12));
        assertEquals(pose + 16 + 12 + 1, in.limit());
    }

    @Test
    void theSimulatorsPoseAndResetMoveTheRobot() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osPacket.of(P2osPacket.data()
                .octet(P2osCommandNumber.SIM_SET_POSE)
                .octet(0x3B)
                .fourOctets(-1000)
                .fourOctets(1500)
                .fourOctets(180)
                .toArray()));
        assertEquals(-1, bench.robot.xMeters());
        assertEquals(0, bench.robot.odometry().xMeters());
        bench.say(P2osCommandNumber.SIM_RESET);
        assertEquals(0, bench.robot.xMeters());
    }

    @Test
    void theBatteryCanBeSet() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.BATTEST, 115).seconds(0.1);
        assertEquals(115, bench.sip().battery());
    }
}
