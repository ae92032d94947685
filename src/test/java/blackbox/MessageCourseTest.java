package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** The course of messages and broadcasts that do not go straight through. */
class MessageCourseTest {
    @Test
    void aPhoneWithoutRoomGetsItsMessageOnceItHasRoomAndTheCentreTellsTheCourse() throws Exception {
        try (Scenario scenario = new Scenario("a phone without room")) {
            RunningProgram center = scenario.center();
            RunningProgram alice = scenario.phone("5550100");
            RunningProgram bob = scenario.phone("5550101");
            bob.ask("memory full\ninbox", "end");
            alice.say("sms 5550101 wait for room");
            String id = center.expect("sms", "state", "accepted").field("id");
            scenario.tell("the phone refuses it, and the centre knows why and when it tries again");
            ConsoleEvent course = center.ask("message " + id, "message");
            while (course.field("attempts").equals("0")) {
                center.ask("wait nothing 1", "error");
                course = center.ask("message " + id, "message");
            }
            assertEquals("awaiting_memory", course.field("standing"));
            assertEquals("memory_full", center.expect("attempt").field("outcome"));
            bob.say("memory free");
            bob.expect("sms", "text", "wait for room");
            center.expect("sms", "id", id, "state", "delivered");
            assertEquals("2", center.ask("message " + id, "message").field("attempts"));
        }
    }

    @Test
    void aPhoneShowsTheChannelsThatItWantsAndARepeatedBroadcastOnce() throws Exception {
        try (Scenario scenario = new Scenario("broadcast channels")) {
            RunningProgram center = scenario.center();
            RunningProgram phone = scenario.phone("5550100", "--channels", "50,900-999");
            center.say("broadcast 51 not wanted");
            center.say("broadcast lang=en every=1 919 twelve degrees");
            phone.expect("broadcast", "channel", "919", "text", "twelve degrees");
            scenario.tell("it is repeated for a while");
            center.ask("wait nothing 3", "error");
            center.say("broadcast update=2 919 thirteen degrees");
            ConsoleEvent next = phone.expectNext("broadcast");
            assertEquals("thirteen degrees", next.field("text"), "neither the unwanted one nor a repetition");
        }
    }

    @Test
    void aTextOfManyPartsOutsideTheGsmAlphabetArrivesWhole() throws Exception {
        try (Scenario scenario = new Scenario("a long message")) {
            scenario.center();
            RunningProgram alice = scenario.phone("5550100");
            RunningProgram bob = scenario.phone("5550101");
            String text = "\u041f\u0440\u0438\u0432\u0435\u0442 \ud83d\ude00\u4f60\u597d".repeat(120);
            alice.say("sms 5550101 " + text);
            assertTrue(Integer.parseInt(alice.expect("sms-sent").field("parts")) > 15);
            assertEquals(text, bob.expect("sms").field("text"));
            alice.say("sms 5550101 " + "x".repeat(255 * 153 + 1));
            assertTrue(alice.expect("error").field("text").contains("more than 255 messages"));
        }
    }
}
