package simrobot.http;

import simgsm.web.JsonText;
import simgsm.web.UrlPaths;
import simrobot.robot.Bumpers;
import simrobot.robot.Condition;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/** A robot's status as JSON: metres, degrees anticlockwise from +X in [0, 360), sonar and laser ranges in millimetres, volts. */
final class StatusJson {
    private StatusJson() {}

    static String all(SimulationSnapshot scene, WebSource source) {
        JsonText json = new JsonText().open('[');
        scene.robots().forEach(robot -> write(json, scene, robot, source));
        return json.close(']').toString();
    }

    static String one(SimulationSnapshot scene, RobotSnapshot robot, WebSource source) {
        JsonText json = new JsonText();
        write(json, scene, robot, source);
        return json.toString();
    }

    private static void write(JsonText json, SimulationSnapshot scene, RobotSnapshot robot, WebSource source) {
        String path = "/robots/" + UrlPaths.encoded(robot.name());
        json.open('{');
        json.name("name").value(robot.name());
        json.name("number").value(source.number(robot.name()));
        json.name("status").value(robot.status().text());
        json.name("power").value(robot.powered());
        json.name("motors").value(robot.motors());
        json.name("behaviour").value(robot.behaviour().text());
        json.name("x").value(robot.xMeters(), 4);
        json.name("y").value(robot.yMeters(), 4);
        json.name("heading").value(degrees(robot.headingRadians()), 2);
        json.name("speed").value(robot.speedMetersPerSecond(), 4);
        json.name("turn").value(Math.toDegrees(robot.turnRadiansPerSecond()), 2);
        condition(json, robot.condition());
        ranges(json, "sonar", robot.sonarRangesMeters());
        ranges(json, "laser", robot.laserRangesMeters());
        json.name("world").value(scene.world().name());
        json.name("time").value(scene.timeNanos() / 1e9, 2);
        json.name("modem").value(source.modem(robot.name()));
        json.name("simulated").value(robot.simulated());
        if (robot.simulated()) {
            json.name("camera").value(path + "/camera.jpg");
            json.name("stream").value(path + "/camera.mjpg");
        }
        json.close('}');
    }

    private static void ranges(JsonText json, String name, double[] meters) {
        json.name(name).open('[');
        for (double range : meters) {
            json.value(Math.round(range * 1000));
        }
        json.close(']');
    }

    private static void condition(JsonText json, Condition condition) {
        json.name("battery").value(condition.batteryVolts(), 2);
        json.name("batteryLow").value(condition.batteryLow());
        json.name("stalled").value(condition.stalled());
        json.name("bumpers").open('{');
        bumpers(json, "front", condition.bumpers().front());
        bumpers(json, "rear", condition.bumpers().rear());
        json.close('}');
        json.name("odometry").open('{');
        json.name("x").value(condition.odometry().xMeters(), 4);
        json.name("y").value(condition.odometry().yMeters(), 4);
        json.name("heading").value(condition.odometry().headingDegrees() % 360, 2);
        json.close('}');
    }

    private static void bumpers(JsonText json, String side, int bits) {
        json.name(side).open('[');
        for (int i = 0; i < Bumpers.COUNT_EACH; i++) {
            json.value((bits >> i & 1) != 0);
        }
        json.close(']');
    }

    /** Degrees rounded to two decimals, in [0, 360). */
    static double degrees(double radians) {
        double hundredths = Math.rint(Math.toDegrees(radians) * 100) % 36000;
        return (hundredths < 0 ? hundredths + 36000 : hundredths) / 100;
    }
}
