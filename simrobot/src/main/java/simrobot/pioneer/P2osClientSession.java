package simrobot.pioneer;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.Consumer;
import simrobot.p2os.InformationPacket;
import simrobot.p2os.P2osCommand;
import simrobot.p2os.P2osCommandNumber;

/**
 * Client side of a P2OS session: three synchronisation steps, each repeated after 1 s, then OPEN, then PULSE after
 * every 0.5 s without a command, because a robot stops when it receives nothing for 2 s.
 */
final class P2osClientSession {
    private static final Logger LOG = System.getLogger(P2osClientSession.class.getName());

    private static final long ANSWER_NANOS = 1_000_000_000;
    private static final long SIGN_OF_LIFE_NANOS = 500_000_000;

    /** The connection is dropped after this time without an information packet. */
    private static final long SILENCE_NANOS = 3_000_000_000L;

    private static final int MOST_SILENT_TRIES = 10;
    private static final int MOST_TRIES = 50;
    private static final int LAST_STEP = 2;
    /** Maximum length of a name in the introduction. */
    private static final int MOST_CHARACTERS = 19;

    private enum Stage {
        APART,
        SYNCHRONISING,
        OPEN
    }

    private final String robot;
    private final PioneerLine line;
    private final Runnable opened;
    private final Consumer<byte[]> said;
    private Stage stage = Stage.APART;
    private final Optional<RobotParameters> parameters;
    private Optional<RobotKind> kind = Optional.empty();
    private String subclass = "";
    private int step;
    private int silentTries;
    private int tries;
    private long sentNanos;
    private long heardNanos;

    /**
     * @param parameters of the robot, for a kind that is not built in
     * @param opened called when the session is open and commands may be sent
     * @param said receives the data of each packet from then on
     */
    P2osClientSession(
            String robot,
            PioneerLine line,
            Optional<RobotParameters> parameters,
            Runnable opened,
            Consumer<byte[]> said) {
        this.robot = robot;
        this.line = line;
        this.parameters = parameters;
        this.opened = opened;
        this.said = said;
    }

    /** The robot's units, by its introduction; empty if its type is unknown. */
    Optional<RobotKind> kind() {
        return kind;
    }

    /** The robot's unknown type: at most 19 printable ASCII characters. */
    Optional<String> unknownType() {
        return stage == Stage.OPEN && kind.isEmpty() ? Optional.of(subclass) : Optional.empty();
    }

    /** Starts the synchronisation on a new connection. */
    void begin(long nanos) {
        stage = Stage.SYNCHRONISING;
        silentTries = 0;
        tries = 0;
        ask(0, nanos);
    }

    /** Ends the session; the connection is lost. */
    void end() {
        stage = Stage.APART;
    }

    void send(byte[] packet, long nanos) {
        if (stage == Stage.OPEN) {
            sentNanos = nanos;
            line.send(packet);
        }
    }

    private void ask(int nextStep, long nanos) {
        step = nextStep;
        sentNanos = nanos;
        if (++tries > MOST_TRIES) {
            giveUp("does not synchronise");
        } else {
            line.send(P2osCommand.packet(step));
        }
    }

    private void giveUp(String why) {
        LOG.log(Level.WARNING, robot + ": the Pioneer " + why + "; trying again");
        stage = Stage.APART;
        line.drop();
    }

    void tick(long nanos) {
        if (stage == Stage.SYNCHRONISING && nanos - sentNanos >= ANSWER_NANOS) {
            if (++silentTries > MOST_SILENT_TRIES) {
                giveUp("does not answer");
            } else {
                ask(step, nanos);
            }
        } else if (stage == Stage.OPEN) {
            if (nanos - heardNanos > SILENCE_NANOS) {
                giveUp("has fallen silent");
            } else if (nanos - sentNanos >= SIGN_OF_LIFE_NANOS) {
                send(P2osCommand.packet(P2osCommandNumber.PULSE), nanos);
            }
        }
    }

    /** @param data data of a packet, at least one byte */
    void heard(byte[] data, long nanos) {
        if (stage == Stage.OPEN) {
            if (InformationPacket.isOne(data)) {
                heardNanos = nanos;
            }
            said.accept(data);
        } else if (stage == Stage.SYNCHRONISING) {
            synchronise(data, nanos);
        }
    }

    private void synchronise(byte[] data, long nanos) {
        int id = data[0] & 0xFF;
        if (InformationPacket.isOne(data)) {
            // an earlier client's session is still open
            line.send(P2osCommand.packet(P2osCommandNumber.CLOSE));
            ask(0, nanos);
        } else if (id == P2osCommandNumber.OUT_OF_ORDER) {
            ask(0, nanos);
        } else if (id == step) {
            silentTries = 0;
            if (step < LAST_STEP) {
                ask(step + 1, nanos);
            } else {
                introduced(data, nanos);
            }
        }
    }

    private void introduced(byte[] data, long nanos) {
        String[] names = new String(data, 1, data.length - 1, StandardCharsets.US_ASCII).split("\0", -1);
        subclass = names.length > 2 ? printable(names[2]) : "";
        kind = RobotParameters.kindOf(subclass, parameters);
        LOG.log(Level.INFO, robot + ": talks with the Pioneer " + names[0] + ", a " + subclass);
        stage = Stage.OPEN;
        heardNanos = nanos;
        send(P2osCommand.packet(P2osCommandNumber.OPEN, 1), nanos);
        opened.run();
    }

    private static String printable(String name) {
        return name.substring(0, Math.min(MOST_CHARACTERS, name.length())).replaceAll("[^!-~]", "?");
    }
}
