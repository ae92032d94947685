package simrobot.p2os;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Commands as packet data: {@code number}, then nothing or one argument. Every byte sequence decodes to something. */
public final class CommandCodec {
    private static final int POSITIVE = 0x3B;
    private static final int NEGATIVE = 0x1B;
    private static final int TEXT = 0x2B;

    private static final int MAX_TEXT = 195;

    private CommandCodec() {}

    // ---- what a client sends ------------------------------------------------------------------------------------

    /** A command without argument, framed. */
    public static byte[] packet(int number) {
        return Packet.of(new byte[] {(byte) number});
    }

    /** A command with a number of -65535 to 65535, framed. */
    public static byte[] packet(int number, int argument) {
        if (Math.abs(argument) > 0xFFFF) {
            throw new IllegalArgumentException("an argument is -65535 to 65535, not " + argument);
        }
        int kind = argument < 0 ? NEGATIVE : POSITIVE;
        return Packet.of(
                new Octets().int1(number).int1(kind).int2(Math.abs(argument)).toBytes());
    }

    /** A command with bytes, framed. */
    public static byte[] packet(int number, byte[] argument) {
        if (argument.length > MAX_TEXT) {
            throw new IllegalArgumentException("at most " + MAX_TEXT + " bytes, not " + argument.length);
        }
        return Packet.of(new Octets()
                .int1(number)
                .int1(TEXT)
                .int1(argument.length)
                .raw(argument)
                .toBytes());
    }

    // ---- what a robot hears -------------------------------------------------------------------------------------

    /** @param data of a packet, at least one byte */
    public static Command decode(byte[] data) {
        int number = data[0] & 0xFF;
        return switch (number) {
            case CommandNumber.PULSE -> new Command.Pulse();
            case CommandNumber.OPEN -> new Command.Open();
            case CommandNumber.CLOSE -> new Command.Close();
            case CommandNumber.SETO -> new Command.SetOrigin();
            case CommandNumber.STOP -> new Command.Stop();
            case CommandNumber.E_STOP, CommandNumber.E_STOP_OLD -> new Command.EmergencyStop();
            case CommandNumber.CONFIG -> new Command.Configuration();
            case CommandNumber.SIM_RESET -> new Command.SimReset();
            case CommandNumber.POLLING -> polling(data);
            case CommandNumber.SIM_SET_POSE -> simPose(data);
            case CommandNumber.SIM_STAT -> new Command.SimStatus(hasNumber(data) ? argument(data) : 1);
            default -> hasNumber(data) ? withNumber(number, argument(data)) : new Command.Unheeded(number);
        };
    }

    private static Command withNumber(int number, int argument) {
        return switch (number) {
            case CommandNumber.ENABLE -> new Command.Enable(argument != 0);
            case CommandNumber.SETA -> new Command.Acceleration(argument);
            case CommandNumber.SETRA -> new Command.TurnAcceleration(argument);
            case CommandNumber.SETV -> new Command.TopSpeed(argument);
            case CommandNumber.SETRV -> new Command.TopTurnSpeed(argument);
            case CommandNumber.MOVE -> new Command.Move(argument);
            case CommandNumber.ROTATE, CommandNumber.RVEL -> new Command.Rotate(argument);
            case CommandNumber.VEL -> new Command.Velocity(argument);
            case CommandNumber.VEL2 -> new Command.WheelVelocities((byte) (argument >> 8), (byte) argument);
            case CommandNumber.HEAD -> new Command.Heading(argument);
            case CommandNumber.DHEAD -> new Command.TurnBy(argument);
            case CommandNumber.DCHEAD -> new Command.TurnByFromTarget(argument);
            case CommandNumber.ENCODER -> new Command.Encoders(argument);
            case CommandNumber.SONAR -> new Command.Sonar(argument != 0);
            case CommandNumber.BUMPSTALL -> new Command.BumpStall((argument & 1) != 0, (argument & 2) != 0);
            case CommandNumber.BATTEST -> new Command.Battery(argument);
            default -> new Command.Unheeded(number);
        };
    }

    private static boolean hasNumber(byte[] data) {
        return data.length >= 4 && (data[1] == POSITIVE || data[1] == NEGATIVE);
    }

    private static int argument(byte[] data) {
        int size = data[2] & 0xFF | (data[3] & 0xFF) << 8;
        return data[1] == NEGATIVE ? -size : size;
    }

    /** The wire counts sonars from 1; 0 is a pause in the firing order. */
    private static Command polling(byte[] data) {
        if (data.length < 3 || data[1] != TEXT || (data[2] & 0xFF) > data.length - 3) {
            return new Command.Unheeded(CommandNumber.POLLING);
        }
        List<Integer> sonars = new ArrayList<>();
        for (byte octet : Arrays.copyOfRange(data, 3, 3 + (data[2] & 0xFF))) {
            if (octet >= 1 && octet <= StandardSip.SONARS) {
                sonars.add(octet - 1);
            }
        }
        return new Command.Polling(List.copyOf(sonars));
    }

    private static Command simPose(byte[] data) {
        return data.length < 14
                ? new Command.Unheeded(CommandNumber.SIM_SET_POSE)
                : new Command.SimPose(int4(data, 2), int4(data, 6), int4(data, 10));
    }

    private static int int4(byte[] data, int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8 | (data[at + 2] & 0xFF) << 16 | (data[at + 3] & 0xFF) << 24;
    }
}
