package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.audio.SoundCardLine;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.file.SecretFile;
import simgsm.file.Utf8Text;
import simgsm.net.ByteLine;
import simgsm.net.LineAddress;
import simgsm.sim.CardPin;
import simgsm.sim.SimSlot;
import simrobot.control.RealModem;
import simrobot.control.RobotName;
import simrobot.pioneer.RobotParameters;
import simrobot.world.Home;
import simrobot.world.World;

/** The robots of a command line. */
public final class RequestedRobots {
    static final String SINGLE_NAME = "robot";
    private static final Msisdn DEFAULT_NUMBER = new Msisdn("5550200");

    private RequestedRobots() {}

    /**
     * At least one robot; names and numbers are all different.
     *
     * @param slot with exactly one card, a single robot has its number
     */
    public static List<RobotName> of(Arguments arguments, SimSlot slot, World world) throws UsageException {
        Msisdn number = firstNumber(arguments, slot);
        if (arguments.has("robots")) {
            arguments.choice("robots", "all");
            if (arguments.has("robot")) {
                throw new UsageException("--robots and --robot: expected one of the two");
            }
            return onAllHomes(world, number);
        }
        if (!arguments.has("robot")) {
            return List.of(new RobotName(SINGLE_NAME, number));
        }
        List<RobotName> robots = new ArrayList<>();
        for (String text : arguments.all("robot")) {
            try {
                RobotName robot = RobotName.parse(text);
                number(robot.number().digits());
                robots.add(robot);
            } catch (IllegalArgumentException e) {
                throw new UsageException("--robot: " + e.getMessage());
            }
        }
        requireDifferent(robots);
        return robots;
    }

    private static Msisdn firstNumber(Arguments arguments, SimSlot slot) throws UsageException {
        Optional<Msisdn> given = arguments.value("number", RequestedRobots::number);
        if (given.isPresent() || slot.isEmpty() || arguments.has("robot")) {
            return given.orElse(DEFAULT_NUMBER);
        }
        return Arguments.checked(() -> slot.card(Optional.empty()))
                .orElseThrow()
                .number();
    }

    /** @throws IllegalArgumentException also if the number gives no IMSI in an open network */
    private static Msisdn number(String text) {
        Msisdn number = Msisdn.parse(text).plain();
        Imsi.ofOpenNumber(number);
        return number;
    }

    /** The address of a real robot; empty if the robots are simulated. */
    public static Optional<LineAddress> real(Arguments arguments, List<RobotName> robots) throws UsageException {
        Optional<LineAddress> address = arguments.value("pioneer", LineAddress::parse);
        if (address.isEmpty() && arguments.has("pioneer-params")) {
            throw new UsageException("--pioneer-params: expected a real robot, named by --pioneer");
        }
        if (address.isPresent()) {
            if (robots.size() > 1) {
                throw new UsageException("--pioneer: expected one robot, found " + robots.size());
            }
            if (arguments.has("behaviour")) {
                throw new UsageException("--behaviour: a real robot (--pioneer) does not start to drive by itself,"
                        + " expected the command behaviour NAME");
            }
            for (String option : List.of("p2os", "ros", "noise")) {
                if (arguments.has(option)) {
                    throw new UsageException("--" + option + ": a real robot (--pioneer) has none of that");
                }
            }
        }
        return address;
    }

    /**
     * The units of a real robot, from a file.
     *
     * @throws IOException if it cannot be read, or describes no robot
     */
    public static Optional<RobotParameters> parameters(Arguments arguments) throws UsageException, IOException {
        Optional<Path> file = arguments.path("pioneer-params");
        return file.isEmpty() ? Optional.empty() : Optional.of(RobotParameters.read(file.get()));
    }

    /** A real modem with its lines; empty if the robots have M2. */
    public static Optional<RealModem> modem(Arguments arguments, List<RobotName> robots)
            throws UsageException, IOException {
        Optional<LineAddress> address = arguments.value("modem", LineAddress::parse);
        Optional<ByteLine> sound = arguments.value("modem-audio", RequestedRobots::sound);
        if (address.isPresent()) {
            if (robots.size() > 1) {
                throw new UsageException("--modem: expected one robot, found " + robots.size());
            }
            for (String option : List.of("sim", "codec", "center", "at", "at-profile", "at-audio")) {
                if (arguments.has(option)) {
                    throw new UsageException("--" + option + ": a real modem (--modem) has none of that");
                }
            }
            if (arguments.has("record-audio") && sound.isEmpty()) {
                throw new UsageException("--record-audio: a real modem (--modem) has sound only with --modem-audio");
            }
        } else if (sound.isPresent()) {
            throw new UsageException("--modem-audio: expected with --modem ADDRESS");
        }
        Optional<String> pin = pin(arguments);
        boolean isPlayed = sound.filter(SoundCardLine.class::isInstance).isEmpty();
        return address.map(line -> new RealModem(line, pin, sound, isPlayed));
    }

    private static ByteLine sound(String text) {
        return text.matches("soundcard(:.+)?")
                ? new SoundCardLine(text.replaceFirst("soundcard:?", ""))
                : LineAddress.parse(text);
    }

    /** The PIN in the file of {@code --pin-file}. */
    static Optional<String> pin(Arguments arguments) throws UsageException, IOException {
        Optional<Path> file = arguments.path("pin-file");
        if (file.isEmpty()) {
            return Optional.empty();
        }
        String pin = Utf8Text.read(file.get()).strip();
        if (!CardPin.isPin(pin)) {
            throw new IOException(file.get() + ": expected a PIN of 4 to 8 digits and nothing else");
        }
        SecretFile.check(file.get());
        return Optional.of(pin);
    }

    private static void requireDifferent(List<RobotName> robots) throws UsageException {
        Set<String> names = new HashSet<>();
        Set<Msisdn> numbers = new HashSet<>();
        for (RobotName robot : robots) {
            if (!names.add(robot.name())) {
                throw new UsageException("--robot: two robots are called " + robot.name());
            }
            if (!numbers.add(robot.number())) {
                throw new UsageException("--robot: two robots have the number " + robot.number());
            }
        }
    }

    private static List<RobotName> onAllHomes(World world, Msisdn first) throws UsageException {
        if (world.items(Home.class).isEmpty()) {
            return List.of(new RobotName(SINGLE_NAME, first));
        }
        List<RobotName> robots = new ArrayList<>();
        UniqueNames names = new UniqueNames();
        for (Home home : world.items(Home.class)) {
            String word = home.name().strip().replaceAll("[^\\p{L}\\p{N}_.+-]+", "_");
            robots.add(new RobotName(names.of(word.isEmpty() ? SINGLE_NAME : word), plus(first, robots.size())));
        }
        return robots;
    }

    /** Appends a number to repeated names, in constant time per name. */
    private static final class UniqueNames {
        private final Set<String> taken = new HashSet<>();
        private final Map<String, Integer> counts = new HashMap<>();

        String of(String base) {
            String name = base;
            while (!taken.add(name)) {
                name = base + "-" + counts.merge(base, 2, (count, first) -> count + 1);
            }
            return name;
        }
    }

    private static Msisdn plus(Msisdn first, int count) throws UsageException {
        try {
            return number(Long.toString(Long.parseLong(first.digits()) + count));
        } catch (IllegalArgumentException e) {
            throw new UsageException("--number: too high to count up from: " + e.getMessage());
        }
    }
}
