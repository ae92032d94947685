package simrobot.app;

import java.util.HashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.audio.SoundCard;
import simgsm.console.Arguments;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.modem.ModemOptions;
import simgsm.modem.at.AtProfile;
import simgsm.sim.SimSlot;
import simgsm.speech.AudioOutput;
import simgsm.speech.SpeechCodec;
import simrobot.control.Fleet;
import simrobot.control.RobotConsole;
import simrobot.process.BehaviourKind;
import vericommand.VeriCommandSettings;

/** SimRobot's options, and what they are read into. */
public final class SimRobotOptions {
    private static final double MIN_SPEED = 0.001;
    private static final double MAX_SPEED = 1000;

    private SimRobotOptions() {}

    public static Options all() {
        return Program.commonOptions(
                        "java -jar simrobot.jar --number 5550200 --world worlds/office.map [options]",
                        "SimRobot: a simulated Pioneer with a GSM modem (M2), driven by telephone keys or SMS.")
                .commands(RobotConsole.COMMANDS)
                .flag("console", Program.CONSOLE_HELP)
                .value("lessons", "DIR", Program.LESSONS_HELP)
                .value("number", "N", "the modem's number (5550200)")
                .collecting("robot", "NAME=NUMBER", "a robot with its own modem and number; repeat it for several")
                .value("robots", "all", "one robot on every RobotHome, numbers counting up from --number")
                .value(
                        "sim",
                        "FILE",
                        "the robots' SIMs, for a closed network: IMSI, number and key; each robot takes the one of"
                                + "\nits number")
                .value(
                        "world",
                        "FILE",
                        "the world: ARIA .map, Saphira .wld, ROS map.yaml with PGM or PNG, or PNG (worlds/demo.map;"
                                + "\na window that you start yourself: the world chosen last)")
                .value("resolution", "METRES", "the width of a pixel of --world FILE.png")
                .value("center", "HOST:PORT", "the SMS/Phone centre (127.0.0.1:3003)")
                .value("codec", "alaw|gsm", "how the modem's speech is coded; it understands both (alaw)")
                .value(
                        "answer-after",
                        "MILLIS",
                        "how long the modem rings before it answers, 0 to 120000 (1500); 0: not at all")
                .value(
                        "record-audio",
                        "FILE.wav",
                        "record all calls in one file, left what the robot sends and right what it hears,"
                                + "\nwith 0.5 s of silence between calls; of several robots each in FILE-NAME.wav;"
                                + "\nan existing file is overwritten")
                .value("operators", "N,N,...", "the only numbers that may command; else every subscriber may")
                .value(
                        "reply",
                        "all|orders|none",
                        "which short messages are answered (all; with --modem orders: those that begin with **)")
                .value("on-hangup", "stop|finish", "what happens to a motion whose call is lost (stop)")
                .value("power", "on|off", "start with the robot switched on or off (on)")
                .value("motors", "on|off", "start with the motors switched on or off (on)")
                .value(
                        "behaviour",
                        "NAME",
                        "wander, wall-follow, one of --behaviours, or none: an autonomous process in every robot"
                                + "\n(none)")
                .value(
                        "behaviours",
                        "DIR",
                        "processes of your own: each .java file there, compiled whenever it is saved, and each jar;"
                                + "\nsee docs/BEHAVIOUR.md")
                .value(
                        "run",
                        "SECONDS",
                        "simulate that long as fast as the machine can, without centre and console, and end")
                .value("runs", "N", "with --run: N runs with seeds that count up, a line of CSV each")
                .value("track", "FILE.csv", "with --run: write pose and status of each robot every 0.1 s")
                .value(
                        "record",
                        "FILE",
                        "record the session: worlds, robots' states, events; an existing file is overwritten")
                .value(
                        "replay",
                        "FILE",
                        "replay a recorded session, in the window with a timeline; headless its events,"
                                + "\nat the pace of --speed or at once")
                .value("replay-from", "SECONDS", "in the window: begin the replay there")
                .value("speed", "N", "simulated seconds per second (1); 0: begin in pause")
                .value(
                        "noise",
                        "N",
                        "errors of wheels and sonars: 0 none (the default), 1 as MobileSim's, at most 10;"
                                + "\nwith --seed they repeat")
                .value(
                        "at",
                        "PORT",
                        "take AT commands for the robots' modems, one port per robot upward from PORT; 0: any free ones")
                .value("at-profile", "plain|sim800", AtProfile.HELP)
                .value("p2os", "PORT", "serve P2OS clients, one port per robot upward from PORT; 0: any free ones")
                .value(
                        "pioneer",
                        "ADDRESS",
                        "drive a real Pioneer, or MobileSim, over P2OS in place of the simulated one:"
                                + "\nHOST:PORT, or a serial line's device file whose speed is set")
                .value(
                        "pioneer-params",
                        "FILE.p",
                        "the units of a real robot whose type is not built in: a params file of ARIA")
                .value(
                        "modem",
                        "ADDRESS",
                        "put a real modem in M2's place, which speaks AT commands: HOST:PORT, or a serial line's"
                                + "\ndevice file whose speed is set")
                .value(
                        "modem-check",
                        "ADDRESS",
                        "try a real modem command by command, print the answers, and end: 0 if it can serve as M2")
                .value(
                        "http",
                        "PORT",
                        "serve a page with map and cameras, status as JSON and pictures; 0: any free port")
                .value("bind", "ADDRESS", "address that AT, P2OS and HTTP ports listen on; default loopback only")
                .flag("print-world", "print what was loaded from the world file, in mm and degrees, and end");
    }

    /** Simulated seconds per second; 0 begins in pause. */
    public static double speed(Arguments arguments) throws UsageException {
        boolean isPaused = arguments.has("speed") && arguments.number("speed", 1, 0, MAX_SPEED) == 0;
        return isPaused ? 0 : arguments.number("speed", 1, MIN_SPEED, MAX_SPEED);
    }

    /** @param single whether there is one robot, whose calls are recorded in the named file itself */
    public static Fleet.Kit kit(Arguments arguments, SimSlot slot, boolean single, long seed, BehaviourKind behaviour)
            throws UsageException {
        boolean power = arguments.choice("power", "on", "off").equals("on");
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        CallRecordings recordings = new CallRecordings(arguments.path("record-audio"), single);
        return new Fleet.Kit(
                seed,
                power,
                motors,
                behaviour,
                arguments.value("codec", SpeechCodec.Kind::named).orElse(SpeechCodec.Kind.A_LAW),
                (int) arguments.integer(
                        "answer-after",
                        ModemOptions.DEFAULT_ANSWER_AFTER_MILLIS,
                        0,
                        ModemOptions.MAX_ANSWER_AFTER_MILLIS),
                recordings,
                number -> Arguments.checked(() -> slot.card(Optional.of(number))));
    }

    /** A window shows at once whether there is a device; a console opens it with the first sound. */
    public static AudioOutput sound(Arguments arguments) {
        if (arguments.has("no-sound")) {
            return AudioOutput.SILENT;
        }
        return arguments.has("headless") ? SoundCard.openWhenPlayed() : SoundCard.open();
    }

    /** The one that is given, or another each time. */
    public static long seed(Arguments arguments) throws UsageException {
        return arguments.has("seed")
                ? arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE)
                : new Random().nextLong();
    }

    /** Who may command, in which language the answers are, and what becomes of a motion whose call is lost. */
    public static VeriCommandSettings settings(Arguments arguments) throws UsageException {
        Set<String> operators =
                arguments.value("operators", SimRobotOptions::operators).orElse(Set.of());
        VeriCommandSettings.OnHangup onHangup =
                arguments.choice("on-hangup", "stop", "finish").equals("stop")
                        ? VeriCommandSettings.OnHangup.STOP
                        : VeriCommandSettings.OnHangup.FINISH;
        boolean isPaid = arguments.has("modem");
        String answered = arguments.choice("reply", isPaid ? "orders" : "all", isPaid ? "all" : "orders", "none");
        return new VeriCommandSettings(
                arguments.language(),
                operators,
                onHangup,
                VeriCommandSettings.Answered.valueOf(answered.toUpperCase(Locale.ROOT)));
    }

    private static Set<String> operators(String list) {
        Set<String> numbers = new HashSet<>();
        for (String number : list.split(",", -1)) {
            numbers.add(Msisdn.parse(number.strip()).digits());
        }
        return numbers;
    }
}
