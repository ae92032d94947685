package simrobot.control;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.console.UsageException;
import simgsm.modem.ModemOptions;
import simgsm.modem.VoiceStore;
import simgsm.net.LineAddress;
import simgsm.sim.InsertedCard;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationOptions;
import simgsm.words.Prompts;
import simrobot.pioneer.PioneerCall;
import simrobot.pioneer.RealPioneer;
import simrobot.pioneer.RobotParameters;
import simrobot.process.BehaviourKind;
import simrobot.process.Surroundings;
import simrobot.process.WaitBudget;
import simrobot.robot.Pioneer;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.Simulation;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.Pose;

/** Creates the robots of a run, from the command line and later, all with the same settings. */
public final class Fleet {
    /** Supplies the recorder of a robot's calls. */
    public interface CallRecorders {
        CallAudioListener of(String robot) throws IOException;
    }

    /** Surroundings of a real robot's process: the world by its map, and no other robots. */
    private record Alone(Simulation simulation) implements Surroundings {
        @Override
        public int robotNumber() {
            return 0;
        }

        @Override
        public World world() {
            return simulation.world();
        }

        @Override
        public List<Position> otherRobots() {
            return List.of();
        }

        @Override
        public WaitBudget waitBudget() {
            return simulation.waitBudget();
        }
    }

    /** Supplies the SIM card of a modem; none in an open network. */
    public interface Cards {
        Optional<InsertedCard> of(Msisdn number) throws UsageException;
    }

    /**
     * Settings of all robots.
     *
     * @param seed determines, with a robot's number, its modem's IMEI
     * @param power true if robots start switched on
     * @param motors true if their motors start switched on
     * @param answerAfterMillis time that a modem rings before it answers
     * @param prompts modems say replies in words with these
     * @param voices modems take orders by voice from the callers in there
     */
    public record Kit(
            long seed,
            boolean power,
            boolean motors,
            BehaviourKind behaviour,
            SpeechCodec.Kind codec,
            int answerAfterMillis,
            Optional<Prompts> prompts,
            Optional<VoiceStore> voices,
            CallRecorders recording,
            Cards cards) {}

    /** Reasons to refuse a robot. */
    public enum Reason {
        NAME_TAKEN,
        NUMBER_TAKEN,
        /** The list has no free SIM, or no SIM can have this number. */
        NO_CARD,
        PLACE_OUTSIDE,
        PLACE_TAKEN,
        /** No place was given, and none is free. */
        NO_PLACE,
        /** The simulation has failed or does not answer in time. */
        NOT_DONE
    }

    /** Thrown if a robot cannot be created as requested; the message is shown on the console. */
    public static final class RobotRefusal extends Exception {
        private final Reason reason;

        RobotRefusal(Reason reason, String message) {
            super(message);
            this.reason = reason;
        }

        public Reason reason() {
            return reason;
        }
    }

    private final SimRobot simRobot;
    private final Kit kit;

    public Fleet(SimRobot simRobot, Kit kit) {
        this.simRobot = simRobot;
        this.kit = kit;
    }

    /**
     * Creates a robot before the start, on the first free home.
     *
     * @param modem the real modem that replaces M2
     */
    public TelephoneRobot addFirst(RobotName name, Simulation simulation, Optional<RealModem> modem)
            throws IOException, UsageException {
        SimulatedRobot robot = placed(name, simulation, Optional.empty());
        return modem.isPresent() ? join(robot, name, modem.get()) : join(robot, name);
    }

    /**
     * Adds a real robot before the start; its assumed pose is the world's first home.
     *
     * @param modem the real modem that replaces M2
     */
    public TelephoneRobot addReal(
            RobotName name,
            LineAddress address,
            Optional<RobotParameters> parameters,
            Simulation simulation,
            Optional<RealModem> modem)
            throws IOException, UsageException {
        PioneerCall call = new PioneerCall(name.name(), address, simRobot.simulation());
        Pose start = simulation.world().items(Home.class).stream()
                .findFirst()
                .map(home -> new Pose(
                        home.position().xMeters(), home.position().yMeters(), Math.toDegrees(home.headingRadians())))
                .orElse(new Pose(0, 0, 0));
        RealPioneer robot = new RealPioneer(name.name(), call, start, kit.motors(), parameters, new Alone(simulation));
        robot.autonomy().setChoice(simulation.behaviours());
        Supplier<RobotSnapshot> guest = robot::snapshot;
        simulation.addGuest(guest);
        TelephoneRobot added = modem.isPresent() ? join(robot, name, modem.get()) : join(robot, name);
        simRobot.onClose(call::close);
        simRobot.onRemoved(gone -> {
            if (gone == added) {
                robot.setPower(false);
                call.end();
                simRobot.simulation().owned().removeGuest(guest);
            }
        });
        call.start(robot);
        if (kit.power()) {
            call.call();
        }
        return added;
    }

    /**
     * Creates a robot while the simulation runs; callable on any thread but the simulation's.
     *
     * @param place its pose; empty selects the first free home, or a place near it
     * @throws RobotRefusal if name, number or place is taken
     */
    public TelephoneRobot add(RobotName name, Optional<Pose> place)
            throws RobotRefusal, IOException, InterruptedException {
        Optional<InsertedCard> card = card(name);
        CallAudioListener recorder = kit.recording().of(name.name());
        try {
            return simRobot.onSimulation(() -> attempt(name, card, place, recorder));
        } catch (IllegalStateException failure) {
            recorder.close();
            throw failure.getCause() instanceof RobotRefusal refusal
                    ? refusal
                    : new RobotRefusal(Reason.NOT_DONE, failure.getMessage());
        }
    }

    private Optional<InsertedCard> card(RobotName name) throws RobotRefusal {
        try {
            Imsi.ofOpenNumber(name.number());
            return kit.cards().of(name.number());
        } catch (UsageException | IllegalArgumentException noCard) {
            throw new RobotRefusal(Reason.NO_CARD, noCard.getMessage());
        }
    }

    private TelephoneRobot attempt(
            RobotName name, Optional<InsertedCard> card, Optional<Pose> place, CallAudioListener recorder)
            throws RobotRefusal {
        if (simRobot.robots().stream().anyMatch(other -> other.number().equals(name.number()))) {
            throw new RobotRefusal(Reason.NUMBER_TAKEN, "another robot has the number " + name.number());
        }
        Simulation simulation = simRobot.simulation().owned();
        try {
            return join(placed(name, simulation, place), name, card, recorder);
        } catch (IllegalArgumentException | IllegalStateException refusal) {
            throw new RobotRefusal(reason(simulation, name, place), refusal.getMessage());
        }
    }

    /**
     * Returns the reason why the robot was not placed; called in the same task as the attempt, so nothing has changed
     * since.
     */
    private Reason reason(Simulation simulation, RobotName name, Optional<Pose> place) {
        if (simulation.robot(name.name()).isPresent()) {
            return Reason.NAME_TAKEN;
        }
        if (place.isEmpty()) {
            return Reason.NO_PLACE;
        }
        Pose there = place.get();
        boolean inside = simulation.world().ground().contains(there.xMeters(), there.yMeters());
        return inside ? Reason.PLACE_TAKEN : Reason.PLACE_OUTSIDE;
    }

    private SimulatedRobot placed(RobotName name, Simulation simulation, Optional<Pose> place) {
        SimulatedRobot robot =
                place.isPresent() ? placed(name, simulation, place.get()) : simulation.addRobot(name.name());
        robot.setMotors(kit.motors());
        robot.setPower(kit.power());
        robot.autonomy().begin(newest(simulation));
        return robot;
    }

    private static SimulatedRobot placed(RobotName name, Simulation simulation, Pose pose) {
        if (!simulation.world().ground().contains(pose.xMeters(), pose.yMeters())) {
            throw new IllegalArgumentException("no place for robot " + name.name() + " at " + pose.xMeters() + " "
                    + pose.yMeters() + ": outside the world");
        }
        return simulation.addRobot(
                name.name(), new Position(pose.xMeters(), pose.yMeters()), Math.toRadians(pose.headingDegrees()));
    }

    /** The current version of the chosen process; none if the list no longer has it. */
    private BehaviourKind newest(Simulation simulation) {
        return simulation.behaviours().kinds().stream()
                .filter(kit.behaviour()::equals)
                .findFirst()
                .orElse(BehaviourKind.NONE);
    }

    private TelephoneRobot join(Pioneer robot, RobotName name) throws IOException, UsageException {
        return join(robot, name, kit.cards().of(name.number()), kit.recording().of(name.name()));
    }

    private TelephoneRobot join(Pioneer robot, RobotName name, RealModem modem) throws IOException {
        return simRobot.addBehind(
                modem, robot, name.number(), options(kit.recording().of(name.name())));
    }

    private ModemOptions options(CallAudioListener recorder) {
        return new ModemOptions(
                new StationOptions(kit.codec(), recorder), kit.answerAfterMillis(), kit.prompts(), kit.voices());
    }

    private TelephoneRobot join(
            Pioneer robot, RobotName name, Optional<InsertedCard> card, CallAudioListener recorder) {
        ModemOptions options = options(recorder);
        Imei imei = imei(name.number());
        return card.isPresent()
                ? simRobot.add(robot, card.get(), imei, options)
                : simRobot.add(robot, name.number(), imei, options);
    }

    /** Includes the number, because robots of one seed would otherwise share an IMEI. */
    private Imei imei(Msisdn number) {
        return Imei.random(new Random(kit.seed() * 31 + number.digits().hashCode()));
    }

    /** Removes a robot and its modem. @return false if no robot has that name */
    public boolean remove(String name) throws InterruptedException {
        return simRobot.onSimulation(() -> {
            Optional<TelephoneRobot> leaving = simRobot.robot(name);
            leaving.ifPresent(simRobot::remove);
            return leaving.isPresent();
        });
    }
}
