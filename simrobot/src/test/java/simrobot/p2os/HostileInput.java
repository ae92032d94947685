package simrobot.p2os;

import java.util.Random;
import simgsm.octets.OctetWriter;

/** Input that breaks the protocol. */
final class HostileInput {
    private HostileInput() {}

    static byte[] next(Random random) {
        return switch (random.nextInt(8)) {
            case 0 -> noise(random, 1 + random.nextInt(4000));
            case 1 -> new byte[] {(byte) 0xFA, (byte) 0xFB, (byte) random.nextInt(3)};
            case 2 -> header(random, random.nextInt(256));
            case 3 -> P2osPacket.of(noise(random, 1 + random.nextInt(198)));
            case 4 -> manyCommands(random);
            case 5 -> cutOff(random);
            case 6 -> wrongChecksum(random);
            default -> lyingLength(random);
        };
    }

    private static byte[] noise(Random random, int length) {
        byte[] bytes = new byte[length];
        random.nextBytes(bytes);
        return bytes;
    }

    private static byte[] header(Random random, int count) {
        return P2osPacket.data()
                .octet(P2osPacket.HEADER_1)
                .octet(P2osPacket.HEADER_2)
                .octet(count)
                .bytes(noise(random, random.nextInt(300)))
                .toArray();
    }

    /** Good packets with any number and any argument, the sensible and the senseless. */
    private static byte[] manyCommands(Random random) {
        OctetWriter octets = P2osPacket.data();
        for (int i = 0; i < 200; i++) {
            int number = random.nextInt(256);
            if (number == P2osCommandNumber.CLOSE) {
                continue;
            }
            octets.bytes(P2osCommand.packet(number, random.nextInt(0x1FFFF) - 0xFFFF));
        }
        return octets.toArray();
    }

    private static byte[] cutOff(Random random) {
        byte[] whole = P2osCommand.packet(P2osCommandNumber.MOVE, random.nextInt(1000));
        return java.util.Arrays.copyOf(whole, random.nextInt(whole.length));
    }

    private static byte[] wrongChecksum(Random random) {
        byte[] packet = P2osCommand.packet(random.nextInt(256), random.nextInt(1000));
        packet[packet.length - 1] ^= (byte) (1 + random.nextInt(255));
        return packet;
    }

    /** A text that says it is longer than it is, a pose that ends early. */
    private static byte[] lyingLength(Random random) {
        int number = random.nextBoolean() ? P2osCommandNumber.POLLING : P2osCommandNumber.SIM_SET_POSE;
        return P2osPacket.of(P2osPacket.data()
                .octet(number)
                .octet(0x2B)
                .octet(200 + random.nextInt(56))
                .bytes(noise(random, random.nextInt(20)))
                .toArray());
    }
}
