package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import vericommand.RobotStatus;

class SessionFuzzTest {
    @Test
    void whateverIsSentTheRobotStaysWhereItMayBeAndTheNextClientIsServed() {
        Random random = new Random(7);
        SessionBench bench = new SessionBench();
        for (int i = 0; i < 300; i++) {
            P2osSession hostile = new P2osSession(
                    bench.robot, bench.robot.pose(), new Nowhere(), new SimulatorRequests() {}, bench.nanos);
            for (int step = 0; step <= 2; step++) {
                hostile.received(P2osCommand.packet(step), bench.simulation.timeNanos(), bench.nanos);
            }
            hostile.received(P2osCommand.packet(P2osCommandNumber.OPEN, 1), bench.simulation.timeNanos(), bench.nanos);
            for (int j = 0; j < 4; j++) {
                hostile.received(HostileInput.next(random), bench.simulation.timeNanos(), bench.nanos);
                bench.simulation.run(5);
                bench.nanos += 50_000_000;
                hostile.tick(bench.simulation.timeNanos(), bench.nanos);
            }
            assertTrue(Double.isFinite(bench.robot.xMeters()) && Double.isFinite(bench.robot.headingRadians()));
            assertTrue(bench.robot.status() != RobotStatus.DISCONNECTED);
            hostile.lost();
        }
        bench.simulation.run(3000);
        bench.robot.setMotors(true);
        bench.open();
        assertEquals(16, bench.sip().sonars().size());
        assertEquals(0, bench.robot.speedMetersPerSecond());
    }

    private record Nowhere() implements PacketOutput {
        @Override
        public void send(byte[] packet) {
            assertTrue(packet.length <= 203);
        }

        @Override
        public void close() {}
    }
}
