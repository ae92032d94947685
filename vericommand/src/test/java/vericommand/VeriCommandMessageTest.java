package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Orders by short message, answered by one short message each. */
class VeriCommandMessageTest {
    private static final String TO = "sms 5550101 ";

    @Test
    void anOrderIsAnsweredOnceWhenItHasEnded() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.sms("** #**20 **");
        assertEquals(List.of("order **#**20** accepted", "under-way true"), bench.events());
        bench.robot.reachGoal();
        assertEquals(
                List.of(
                        "ended #**20",
                        "outcome 3 Done: #**20. Stopped at 1.200 0.500 m, heading 90.0.",
                        TO + "3 Done: #**20. Stopped at 1.200 0.500 m, heading 90.0.",
                        "under-way false"),
                bench.events());
    }

    @Test
    void aRobotOfAnUnknownTypeNamesItsTypeWhereItRefuses() {
        Bench bench = Bench.in(RobotStatus.NO_MOTORS);
        bench.robot.unknownType = Optional.of("rover9");
        bench.sms("** #**20 **");
        assertEquals(List.of(TO + "8 Not possible: robot type rover9 is not known."), bench.events("sms"));
        bench.veri.callBegan("5550101");
        "**#**20**".chars().forEach(key -> bench.veri.key((char) key));
        assertEquals(List.of("tone 8"), bench.events("tone"));
    }

    @Test
    void aWholeTripIsNamedInItsReplyOrCountedIfItIsTooLong() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.sms("** #**100 #*#90 #**100 **");
        for (int i = 0; i < 3; i++) {
            bench.robot.reachGoal();
        }
        assertEquals(
                List.of(TO + "3 Done: #**100 #*#90 #**100. Stopped at 1.200 0.500 m, heading 90.0."),
                bench.events("sms"));
        bench.sms("**" + "#*#123".repeat(32) + "**");
        for (int i = 0; i < 32; i++) {
            bench.robot.reachGoal();
        }
        assertEquals(
                List.of(TO + "3 Done: 32 instructions. Stopped at 1.200 0.500 m, heading 90.0."), bench.events("sms"));
    }

    @Test
    void aReplyOf160CharactersNamesTheInstructionsAndALongerOneCountsThem() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        String longest = "#**1000 ".repeat(14).strip();
        String named = "3 Done: " + longest + ". Stopped at 1.200 0.500 m, heading 90.0.";
        assertEquals(Reply.MAX_MESSAGE_CHARACTERS, named.length());
        bench.sms("** " + longest + " **");
        for (int i = 0; i < 14; i++) {
            bench.robot.reachGoal();
        }
        assertEquals(List.of(TO + named), bench.events("sms"));
        bench.sms("** " + "#**1000 ".repeat(13) + "### #**5 **");
        for (int i = 0; i < 14; i++) {
            bench.robot.reachGoal();
        }
        assertEquals(
                List.of(TO + "3 Done: 15 instructions. Stopped at 1.200 0.500 m, heading 90.0."), bench.events("sms"));
    }

    @Test
    void aReplyOfMoreThan160CharactersIsRefused() {
        assertEquals(
                Reply.MAX_MESSAGE_CHARACTERS,
                new Reply(ReplyTone.EXECUTED, "x".repeat(158)).message().length());
        assertThrows(IllegalArgumentException.class, () -> new Reply(ReplyTone.EXECUTED, "x".repeat(159)));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "STOPPED|** #** **|7 Not a valid command: number expected at key 6. Range 1..9999 cm.",
                "STOPPED|hello|7 Not a valid command: ** expected at key 1.",
                "DISCONNECTED|** #**20 **|2 Connection denied: the robot is off.",
                "DISCONNECTED|** #*0 **|2 Connection denied: the robot is off.",
                "NO_MOTORS|** #**20 **|8 Not possible: no motors.",
                "NO_MOTORS|** #*0 **|8 Not possible: no motors. No motors at 1.200 0.500 m, heading 90.0.",
                "COLLISION|** #**20 **|8 Not possible: collision.",
                "COLLISION|** #*0 **|4 Collision at 1.200 0.500 m, heading 90.0.",
                "COLLISION|** ### **|3 Done: ###. Collision at 1.200 0.500 m, heading 90.0.",
                "STOPPED|** #*0 **|3 Done: #*0. Stopped at 1.200 0.500 m, heading 90.0.",
                "MOVING|** #**20 **|6 Executing a command.",
                "MOVING|** #*0 **|6 Executing a command. Moving at 1.200 0.500 m, heading 90.0."
            })
    void anOrderThatMovesNothingIsAnsweredAtOnce(RobotStatus status, String order, String reply) {
        Bench bench = Bench.in(status);
        bench.sms(order);
        assertEquals(List.of(TO + reply), bench.events("sms"));
    }

    @Test
    void anEmptyMessageIsNoValidCommand() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.sms(" ");
        assertEquals(
                List.of(
                        "order  invalid",
                        "outcome 7 Not a valid command: ** expected at key 1.",
                        TO + "7 Not a valid command: ** expected at key 1."),
                bench.events());
    }

    @Test
    void theOrderThatAStopHasStoppedSaysHowFarItGot() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.sms("** #**20 **");
        bench.sms("5550102", "** ### **");
        bench.robot.stand(12.2);
        assertEquals(
                List.of(
                        TO + "8 Stopped by order after 12 of 20 cm",
                        "sms 5550102 3 Done: ###. Stopped at 1.200 0.500 m, heading 90.0."),
                bench.events("sms"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "en|POWER_OFF|2 Connection denied: the robot is off. Ended after 12 of 20 cm, instruction 2 of 2.",
                "en|MOTORS_OFF|8 Not possible: no motors. Ended after 12 of 20 cm, instruction 2 of 2.",
                "en|MOTION_ENDED|8 Not possible: the world has changed. Ended after 12 of 20 cm, instruction 2 of 2.",
                "es|POWER_OFF|2 Acceso denegado: el robot no tiene corriente. Termina tras 12 de 20 cm, paso 2 de 2.",
                "es|MOTION_ENDED|8 No es posible: el mundo ha cambiado. Termina tras 12 de 20 cm, paso 2 de 2."
            })
    void anOrderCutShortSaysWhyAndHowFarItGot(String language, StatusEvent event, String reply) {
        Bench bench =
                Bench.with(new VeriCommandSettings(new Locale(language), Set.of(), VeriCommandSettings.OnHangup.STOP));
        bench.sms("** #*#90 #**20 **");
        bench.robot.reachGoal();
        bench.robot.end(event, MotionOutcome.Ending.ABORTED, 12.2);
        assertEquals(List.of(TO + reply), bench.events("sms"));
    }

    @Test
    void aStopInACallStopsAMessagesOrderAndEachIsAnsweredWhereItCameFrom() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.sms("** #*#200 **");
        bench.press("**#**20**");
        bench.press("**###**");
        bench.robot.stand(55);
        assertEquals(
                List.of("tone 6", TO + "8 Stopped by order after 55 of 200 degrees", "tone 3"),
                bench.events("tone", "sms"));
    }

    @Test
    void theEndOfACallLeavesAMessagesOrderAlone() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.sms("** #**20 **");
        bench.veri.callEnded();
        assertEquals(0, bench.robot.brakes);
        bench.robot.reachGoal();
        assertEquals(1, bench.events("sms").size());
    }

    @Test
    void aSenderThatIsNoOperatorGetsNoAnswerAndNothingMoves() {
        Bench bench = Bench.with(Bench.settings(VeriCommandSettings.OnHangup.STOP, "5550100"));
        bench.sms("** #**20 **");
        bench.sms("nonsense");
        assertEquals(List.of("ignored 5550101", "ignored 5550101"), bench.events());
        assertTrue(bench.robot.started.isEmpty());
    }

    @ParameterizedTest
    @CsvSource({
        "5550101, 5550101, true",
        "5550101, +5550101, true",
        "5550101, 55501011, false",
        "6245*, 624500000001, true",
        "6245*, +6245, true",
        "6245*, 6244, false",
        "6245*, '', false",
    })
    void anOperatorIsANumberOrABeginning(String operator, String number, boolean isPermitted) {
        assertEquals(
                isPermitted,
                Bench.settings(VeriCommandSettings.OnHangup.STOP, "1", operator).permits(number));
    }

    @Test
    void repliesCanBeSpanish() {
        Bench bench = Bench.with(
                new VeriCommandSettings(Locale.forLanguageTag("es"), Set.of(), VeriCommandSettings.OnHangup.STOP));
        bench.sms("** #** **");
        bench.sms("** #**20 **");
        bench.robot.collide(12);
        assertEquals(
                List.of(
                        TO + "7 La orden no vale: se espera un valor en la tecla 6. Rango 1..9999 cm.",
                        TO + "4 Choque tras 12 de 20 cm, paso 1 de 1."),
                bench.events("sms"));
    }

    /** Without end before: each robot answered the other's 7 with another 7. */
    @Test
    void aReplyOfARobotIsNeitherAnsweredNorTakenAsAnOrder() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        List<String> replies = List.of(
                "7 Not a valid command: ** expected at key 1.",
                "7 La orden no vale: se espera un valor en la tecla 6. Rango 1..9999 cm.",
                "7 Not a valid command: no process 3 at key 10. Processes: 1 wander, 2 wall-follow.",
                "3 Done: #**20. Stopped at 1.200 0.500 m, heading 90.0.",
                "4 Collision at 1.200 0.500 m, heading 90.0.",
                " 4 Choque tras 12 de 20 cm, paso 1 de 1.\n",
                "5 Process wander ended: no way",
                "6 Iniciado el proceso 1: wander.",
                "8 Stopped by order after 12 of 20 cm",
                "2 Connection denied: the robot is off. Ended after 12 of 20 cm, instruction 2 of 2.");
        for (String reply : replies) {
            bench.sms(reply);
            assertEquals(List.of("reply-ignored 5550101"), bench.events(), reply);
        }
        assertEquals(0, bench.changes);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "7",
                "7 ",
                "3 tables please",
                "4 Done: #**20. Stopped",
                "Not a valid command: x expected at key 1.",
                "hello"
            })
    void otherTextsAreStillAnswered(String text) {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.sms(text);
        assertEquals(List.of(TO + "7 Not a valid command: ** expected at key 1."), bench.events("sms"));
    }

    @Test
    void aSenderIsAnswered300TimesAMinuteForMessagesWithoutAValidOrder() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        for (int i = 0; i < 1000; i++) {
            bench.nowNanos += 10_000_000;
            bench.sms(i % 2 == 0 ? "I am away" : "** #*9 **");
        }
        List<String> events = bench.events("sms", "order", "silenced");
        assertEquals(601, events.size());
        assertEquals("silenced 5550101", events.get(600));
        bench.sms("5550102", "hello");
        bench.sms("** #*0 **");
        assertEquals(
                List.of(
                        "sms 5550102 7 Not a valid command: ** expected at key 1.",
                        TO + "3 Done: #*0. Stopped at 1.200 0.500 m, heading 90.0."),
                bench.events("sms"));
        bench.nowNanos = 3_010_000_000L + 59_999_999_999L;
        bench.sms("hello");
        assertEquals(List.of(), bench.events());
        bench.nowNanos++;
        bench.sms("hello");
        assertEquals(List.of(TO + "7 Not a valid command: ** expected at key 1."), bench.events("sms"));
    }

    @Test
    void theAnswersCountInAnyMinute() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        for (int i = 0; i < 1000; i++) {
            bench.nowNanos += 200_000_000L;
            bench.sms("hello");
        }
        assertEquals(1000, bench.events("sms").size());
        bench.nowNanos += 199_999_999L;
        bench.sms("hello");
        assertEquals(List.of("silenced 5550101"), bench.events());
    }

    @Test
    void numbersHaveNoNegativeZeroAndHeadingsStayBelow360() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.robot.pose = new Pose(-0.0001, -12.3456, 359.97);
        bench.sms("** #*0 **");
        bench.robot.pose = new Pose(0, 0, -90);
        bench.sms("** #*0 **");
        assertEquals(
                List.of(
                        TO + "3 Done: #*0. Stopped at 0.000 -12.346 m, heading 0.0.",
                        TO + "3 Done: #*0. Stopped at 0.000 0.000 m, heading 270.0."),
                bench.events("sms"));
    }

    @Test
    void theLongestRepliesStillFitOneMessage() {
        Pose far = new Pose(-12345.678, -12345.678, 359.9);
        Instruction.Motion motion = new Instruction.Forward(9999);
        OrderProgress progress = new OrderProgress(motion, 9998.6, 32, 32);
        for (Locale locale : List.of(Locale.ENGLISH, Locale.forLanguageTag("es"))) {
            ReplyTexts texts = new ReplyTexts(locale);
            for (RobotStatus status : RobotStatus.values()) {
                Order longest = new Order("**", java.util.Collections.nCopies(32, motion));
                assertTrue(texts.done(longest, status, far).message().length() <= 160);
                assertTrue(texts.report(longest, status, far).message().length() <= 160);
                assertTrue(texts.aborted(progress, status).message().length() <= 160);
                assertTrue(ReplyForms.isReply(texts.aborted(progress, status).message()));
            }
            for (ExpectedKeys expected : ExpectedKeys.values()) {
                for (OrderFault.Limit limit : OrderFault.Limit.values()) {
                    OrderFault fault = new OrderFault("", 99999, expected, limit, true);
                    assertTrue(
                            texts.invalid(fault).message().length() <= 160
                                    && ReplyForms.isReply(texts.invalid(fault).message()),
                            texts.invalid(fault).message());
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "ALL, Hi there, true",
        "ALL, ** #*0 **, true",
        "ORDERS, Hi there, false",
        "ORDERS, #**20, false",
        "ORDERS, ** #*0 **, true",
        "ORDERS, '* * #*7 *', true",
        "NONE, Hi there, false",
        "NONE, ** #*0 **, false"
    })
    void aMessageIsAnsweredAsTheSettingSays(VeriCommandSettings.Answered setting, String text, boolean isAnswered) {
        Bench bench = Bench.with(
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP, setting));
        bench.sms(text);
        assertEquals(
                isAnswered,
                bench.events().stream().anyMatch(event -> event.startsWith("sms")),
                bench.events().toString());
    }
}
