package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** {@code --demo --class N}: several phones and robots in one world. */
@ResourceLock("port 3003")
class ClassModeTest {
    @Test
    void twoStudentsDriveTheirRobotsAndTheTableHasThem() throws Exception {
        FinishedProgram demo =
                FinishedProgram.run("simgsm-center", "--demo", "--class", "2", "--lang", "en", "--no-sound");
        assertEquals(0, demo.status(), demo.output() + demo.error());
        assertTrue(demo.output()
                .matches("(?s).*student number=5550101 robot=5550201 command=\"java -jar "
                        + "simgsm-phone.jar --number 5550101 --center 127.0.0.1:[0-9]+\"\n.*"));
        for (int student = 0; student < 2; student++) {
            String row = "result number=555010" + student + " robot=555020" + student
                    + " orders=1 keys=9 collisions=0 seconds=\"\"\n";
            assertTrue(demo.output().contains(row), demo.output());
        }
    }

    /** Twenty messages within a second: 20 robots drive at the same time. */
    @Test
    void twentyRobotsOfAClassDriveSixtyCentimetersAtOnceWithoutCollision() throws Exception {
        try (Scenario scenario = new Scenario("a class of twenty")) {
            RunningProgram teacher = scenario.start(
                    "class", "simgsm-center", "--demo", "--class", "20", "--headless", "--console", "--port", "0");
            String port = teacher.expect("ready").field("port");
            ConsoleEvent student = teacher.expect("student", "number", "5550119", "robot", "5550219");
            assertEquals(
                    "java -jar simgsm-phone.jar --number 5550119 --center 127.0.0.1:" + port, student.field("command"));
            RunningProgram phone = scenario.start(
                    "phone",
                    "simgsm-phone",
                    "--headless",
                    "--no-sound",
                    "--number",
                    "5550107",
                    "--center",
                    "127.0.0.1:" + port);
            phone.say("name Ana, \"7\"").expect("ussd", "text", "Hello, Ana, \"7\".");
            teacher.expect("attached", "number", "5550219");
            for (int i = 0; i < 20; i++) {
                phone.say("sms " + (5550200 + i) + " **#**60**");
            }
            for (int i = 0; i < 20; i++) {
                ConsoleEvent reply = phone.expect("sms");
                assertTrue(reply.field("text").startsWith("3 Done: #**60. Stopped at "), reply.toString());
            }
            teacher.say("class");
            for (int i = 0; i < 20; i++) {
                teacher.expect(
                        "class",
                        "number",
                        "" + (5550100 + i),
                        "name",
                        i == 7 ? "Ana, \"7\"" : "",
                        "robot",
                        "" + (5550200 + i),
                        "orders",
                        "1",
                        "collisions",
                        "0",
                        "lesson",
                        "",
                        "score",
                        "");
            }
            teacher.expect("end", "of", "class", "count", "20");
        }
    }

    @Test
    void aClosedClassNeedsACardForEachStudentAndRobot(@TempDir Path folder) throws Exception {
        String list = folder.resolve("class.hlr").toString();
        FinishedProgram.run("simgsm-center", "--hlr", list, "--new-sim", "5550100,5550101,5550200");
        FinishedProgram demo = FinishedProgram.run("simgsm-center", "--demo", "--class", "3", "--hlr", list);
        assertEquals(2, demo.status(), demo.output());
        assertTrue(
                demo.error().contains("--class: expected SIMs of 5550102, 5550201, 5550202 in " + list), demo.error());
        FinishedProgram web = FinishedProgram.run("simgsm-center", "--demo", "--web", "0", "--hlr", list);
        assertEquals(2, web.status(), web.output());
        assertTrue(web.error().contains("--web: browsers have no SIM card"), web.error());
    }

    @Test
    void aClassNeedsADemoAndANumberOfStudents() throws Exception {
        assertEquals(2, FinishedProgram.run("simgsm-center", "--class", "2").status());
        assertEquals(
                2,
                FinishedProgram.run("simgsm-center", "--demo", "--class", "0").status());
        FinishedProgram lesson =
                FinishedProgram.run("simgsm-center", "--demo", "--class", "2", "--lesson", "twelve-keys");
        assertEquals(2, lesson.status());
        assertTrue(lesson.error().contains("--class: the teacher's windows begin no lesson"), lesson.error());
    }
}
