package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simrobot.robot.Laser;

/** What a client gets from the simulated laser, and asks of the simulator. The robot looks at a wall 1 m ahead. */
class LaserReportsTest {
    /** As ARIA does it: from the right to the left, a degree apart, then on. */
    private static SessionBench withLaser(int mode) {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.LASER_START, -90).say(P2osCommandNumber.LASER_END, 90);
        bench.say(P2osCommandNumber.LASER_STEP, 100).say(P2osCommandNumber.LASER, mode);
        bench.heard.clear();
        return bench.seconds(0.1);
    }

    private static int two(byte[] data, int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8;
    }

    /** The readings of one scan. @param head octets before the counts @param size octets of a reading */
    private static List<Integer> readings(List<byte[]> packets, int head, int size) {
        List<Integer> readings = new ArrayList<>();
        for (byte[] packet : packets) {
            assertEquals(readings.size(), two(packet, head + 2), "number of the first reading");
            int count = packet[head + 4] & 0xFF;
            assertTrue(count <= 32);
            for (int i = 0; i < count; i++) {
                readings.add(two(packet, head + 5 + i * size));
            }
        }
        return readings;
    }

    @Test
    void extendedPacketsHold181ReadingsFromTheRightToTheLeft() {
        List<byte[]> packets = withLaser(2).packets(0x61);
        assertEquals(6, packets.size());
        assertEquals(181, two(packets.get(0), 1));
        assertEquals(6 + 5 * 32 + 2, packets.get(0).length);
        List<Integer> readings = readings(packets, 1, 5);
        assertEquals(181, readings.size());
        double ahead = 1000 - Laser.MOUNT_METERS * 1000;
        assertEquals(ahead, readings.get(90), 1);
        assertEquals(ahead / Math.cos(Math.toRadians(60)), readings.get(150), 1);
        assertEquals(32_000, readings.get(0));
        assertEquals(32_000, readings.get(180));
    }

    @Test
    void plainPacketsBeginWithTheOdometry() {
        SessionBench bench = withLaser(1);
        List<byte[]> packets = bench.packets(0x60);
        assertEquals(6, packets.size());
        assertEquals(181, readings(packets, 7, 2).size());
        bench.robot.drive().move(0.3);
        bench.seconds(4);
        byte[] last = bench.packets(0x60).get(bench.packets(0x60).size() - 1);
        assertEquals(300, two(last, 1), 1);
    }

    @Test
    void aScanComesWithEveryInformationPacketUntilTheClientSwitchesItOffOrLeaves() {
        SessionBench bench = withLaser(2);
        assertTrue(bench.robot.laser().isOn());
        assertEquals(181, bench.simulation.snapshot().robots().get(0).laserRangesMeters().length);
        bench.seconds(0.9);
        assertEquals(60, bench.packets(0x61).size());
        bench.say(P2osCommandNumber.LASER, 0).seconds(1);
        assertEquals(60, bench.packets(0x61).size());
        assertFalse(bench.robot.laser().isOn());
        bench.say(P2osCommandNumber.SIM_LRF_ENABLE, 2).seconds(0.1);
        assertEquals(66, bench.packets(0x61).size());
        bench.say(P2osCommandNumber.CLOSE);
        assertFalse(bench.robot.laser().isOn());
        assertEquals(0, bench.simulation.snapshot().robots().get(0).laserRangesMeters().length);
    }

    @ParameterizedTest
    @CsvSource({"-45, 45, 50, 181", "0, 0, 100, 1", "-180, 180, 25, 1441", "-30, 30, 700, 9"})
    void theFieldIsTheClients(int start, int end, int hundredths, int count) {
        SessionBench bench = withLaser(0);
        bench.say(P2osCommandNumber.SIM_LRF_START, start).say(P2osCommandNumber.SIM_LRF_END, end);
        bench.say(P2osCommandNumber.SIM_LRF_STEP, hundredths).say(P2osCommandNumber.SIM_LRF_ENABLE, 2);
        assertEquals(count, readings(bench.seconds(0.1).packets(0x61), 1, 5).size());
    }

    @ParameterizedTest
    @CsvSource({"90, -90, 100", "-90, 90, 0", "-90, 90, -5", "-90, 90, 1", "-200, 0, 100", "-180, 181, 100"})
    void aFieldThatNoLaserHasGivesNoPackets(int start, int end, int hundredths) {
        SessionBench bench = withLaser(2);
        bench.say(P2osCommandNumber.LASER_START, start).say(P2osCommandNumber.LASER_END, end);
        bench.say(P2osCommandNumber.LASER_STEP, hundredths);
        bench.heard.clear();
        assertEquals(List.of(), bench.seconds(0.3).packets(0x61));
        assertFalse(bench.sips().isEmpty());
    }

    // ---- requests to the simulator -------------------------------------------------------------------------------

    private static byte[] control(int operation, int length, String file) {
        byte[] name = file.getBytes(StandardCharsets.UTF_8);
        byte[] data = new byte[6 + name.length];
        data[0] = (byte) P2osCommandNumber.SIM_CTRL;
        data[1] = 0x3B;
        data[2] = (byte) operation;
        data[4] = (byte) length;
        data[5] = (byte) (length >> 8);
        System.arraycopy(name, 0, data, 6, name.length);
        return data;
    }

    @Test
    void aWorldIsLoadedByItsNameAndOtherOperationsAreNotServed() {
        assertEquals(Optional.of("office.map"), worldFile(control(1, 11, "office.map\0")));
        assertEquals(Optional.of("office"), worldFile(control(2, 6, "office.map")));
        assertEquals(Optional.of("office.map"), worldFile(control(1, 60_000, "office.map")));
        assertEquals(Optional.empty(), worldFile(control(5, 0, "")));
        assertEquals(Optional.empty(), worldFile(new byte[] {(byte) P2osCommandNumber.SIM_CTRL, 0x3B, 1, 0}));
    }

    private static Optional<String> worldFile(byte[] data) {
        return new P2osCommand(data).worldFile();
    }

    @Test
    void requestsGoToTheSimulator() {
        List<String> asked = new ArrayList<>();
        SessionBench bench = new SessionBench();
        P2osSession session = new P2osSession(
                bench.robot,
                bench.robot.pose(),
                bench,
                new SimulatorRequests() {
                    @Override
                    public void loadWorld(String robot, String file) {
                        asked.add(robot + " loads " + file);
                    }

                    @Override
                    public void show(String robot, String text) {
                        asked.add(robot + " says " + text);
                    }
                },
                bench.nanos);
        for (int command : new int[] {0, 1, 2, 1}) {
            session.received(P2osCommand.packet(command), 0, bench.nanos);
        }
        session.received(P2osPacket.of(control(1, 10, "office.map")), 0, bench.nanos);
        byte[] hello = "hello".getBytes(StandardCharsets.UTF_8);
        session.received(P2osCommand.packet(P2osCommandNumber.SIM_MESSAGE, hello), 0, bench.nanos);
        assertEquals(List.of("robot loads office.map", "robot says hello"), asked);
    }
}
