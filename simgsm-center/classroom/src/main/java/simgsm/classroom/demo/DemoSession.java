package simgsm.classroom.demo;

import simgsm.console.Event;
import simgsm.console.TextBundle;

/** The scripted session: each step says what it expects and how long it waits for it. */
final class DemoSession {
    /** Starting two Java programs on a slow machine. */
    private static final int START_SECONDS = 60;

    private static final int ANSWER_SECONDS = 20;
    /** Driving at half a metre a second, at real speed. */
    private static final int DRIVE_SECONDS = 60;

    private static final double CENTIMETRES_20 = 0.20;
    private static final double TOLERANCE_METRES = 0.001;

    private final DemoConsole phone;
    private final DemoConsole robot;
    private final DemoTranscript transcript;
    private final TextBundle texts;

    DemoSession(DemoConsole phone, DemoConsole robot, DemoTranscript transcript, TextBundle texts) {
        this.phone = phone;
        this.robot = robot;
        this.transcript = transcript;
        this.texts = texts;
    }

    void play() throws DemoFailure, InterruptedException {
        phone.await(START_SECONDS, "registered");
        robot.await(START_SECONDS, "registered");
        driveByTones();
        beRefused();
        driveByMessage();
        collide();
        end();
    }

    private void driveByTones() throws DemoFailure, InterruptedException {
        transcript.heading(texts.of("demo.drive"));
        double before = x();
        dial();
        press("** #**20 **");
        hear("6");
        hear("3");
        double moved = x() - before;
        if (Math.abs(moved - CENTIMETRES_20) > TOLERANCE_METRES) {
            throw new DemoFailure("robot: expected to have moved 0.2000 m, found " + moved + " m");
        }
        press("** #**0 **");
        hear("7");
        hangUp();
    }

    private void beRefused() throws DemoFailure, InterruptedException {
        transcript.heading(texts.of("demo.refusal"));
        robot.command("motors off");
        robot.await(ANSWER_SECONDS, "status", "value=No motors");
        dial();
        press("** #**20 **");
        hear("8");
        hangUp();
        robot.command("motors on");
        robot.await(ANSWER_SECONDS, "status", "value=Stopped");
    }

    private void driveByMessage() throws DemoFailure, InterruptedException {
        transcript.heading(texts.of("demo.message"));
        phone.command("sms " + DemoPrograms.ROBOT_NUMBER + " ** #**20 **");
        phone.await(ANSWER_SECONDS, "sms-sent", "to=" + DemoPrograms.ROBOT_NUMBER);
        phone.await(
                DRIVE_SECONDS,
                "sms",
                reply -> reply.fields().getOrDefault("text", "").startsWith("3 "),
                "text=\"3 ...\"");
    }

    private void collide() throws DemoFailure, InterruptedException {
        transcript.heading(texts.of("demo.collision"));
        dial();
        press("** #**9999 **");
        hear("6");
        hear("4");
        robot.await(ANSWER_SECONDS, "status", "value=Collision");
        hangUp();
        robot.command("pose");
        robot.await(ANSWER_SECONDS, "pose");
    }

    private void end() throws DemoFailure, InterruptedException {
        phone.command("quit");
        phone.awaitEnd(ANSWER_SECONDS);
        robot.command("quit");
        robot.awaitEnd(ANSWER_SECONDS);
    }

    private double x() throws DemoFailure, InterruptedException {
        robot.command("pose");
        Event pose = robot.await(ANSWER_SECONDS, "pose");
        return Double.parseDouble(pose.fields().getOrDefault("x", "NaN"));
    }

    private void dial() throws DemoFailure, InterruptedException {
        phone.command("dial " + DemoPrograms.ROBOT_NUMBER);
        phone.await(ANSWER_SECONDS, "connected");
        hear("1");
    }

    private void press(String keys) throws DemoFailure, InterruptedException {
        phone.command("press " + keys);
    }

    private void hear(String tone) throws DemoFailure, InterruptedException {
        phone.await(DRIVE_SECONDS, "tone", "key=" + tone);
    }

    private void hangUp() throws DemoFailure, InterruptedException {
        phone.command("hangup");
        phone.await(ANSWER_SECONDS, "released", "cause=16");
    }
}
