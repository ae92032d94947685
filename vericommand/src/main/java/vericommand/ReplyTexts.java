package vericommand;

import java.util.Locale;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** The replies as texts. The Spanish ones use only letters of the GSM alphabet: é and ñ, but not á, í, ó, ú. */
final class ReplyTexts {
    /** Characters of a reply's list of numbers. */
    private static final int MOST_RANGES = 75;

    private final Locale locale;
    private final Supplier<Optional<String>> unknownType;

    ReplyTexts(Locale locale) {
        this(locale, Optional::empty);
    }

    /** @param unknownType supplies {@link Robot#unknownType} */
    ReplyTexts(Locale locale, Supplier<Optional<String>> unknownType) {
        this.locale = locale;
        this.unknownType = unknownType;
    }

    ReplyTexts in(Locale language) {
        return new ReplyTexts(language, unknownType);
    }

    /** All instructions are executed. */
    Reply done(Order order, RobotStatus status, Pose pose) {
        String where = where(status, pose);
        String text = text("reply.done", order.instructionKeys(), where);
        if (text.length() > Reply.MAX_MESSAGE_CHARACTERS - 2) {
            text = text("reply.done.many", "" + order.instructions().size(), where);
        }
        return new Reply(ReplyTone.EXECUTED, text);
    }

    /** The reply with a warning, if that fits. */
    Reply withLowBattery(Reply reply) {
        String text = reply.text() + " " + text("reply.battery");
        return text.length() > Reply.MAX_MESSAGE_CHARACTERS - 2 ? reply : new Reply(reply.tone(), text);
    }

    /** The answer to a question that moves nothing: status and pose, or the reason why it is none. */
    String answer(Recognition question, RobotStatus status, Pose pose) {
        if (question instanceof Recognition.Broken broken) {
            return invalid(broken.fault()).message();
        }
        boolean isReport = question instanceof Recognition.Complete complete
                && complete.order().instructions().stream().allMatch(Instruction.ReportStatus.class::isInstance);
        return isReport ? where(status, pose) : text("reply.report-only");
    }

    /** The reply to an order that only asks for the status. */
    Reply report(Order order, RobotStatus status, Pose pose) {
        String where = where(status, pose);
        return switch (status) {
            case STOPPED -> done(order, status, pose);
            case COLLISION -> new Reply(ReplyTone.COLLISION, where);
            case MOVING -> new Reply(ReplyTone.EXECUTING, text("reply.executing") + " " + where);
            case NO_MOTORS -> new Reply(ReplyTone.NOT_POSSIBLE, notPossible(status) + " " + where);
            case DISCONNECTED -> denied();
        };
    }

    /** A motion ended in a collision or in an infinite loop. */
    Reply failed(ReplyTone tone, OrderProgress progress) {
        String key = tone == ReplyTone.COLLISION ? "reply.collision" : "reply.loop";
        return new Reply(tone, text(key, progress.amounts(this), progress.place(this)));
    }

    /** A motion was ended by the power or the motors; in any other status by a change of the world. */
    Reply aborted(OrderProgress progress, RobotStatus status) {
        Reply why = switch (status) {
            case DISCONNECTED -> denied();
            case NO_MOTORS -> new Reply(ReplyTone.NOT_POSSIBLE, notPossible(status));
            default -> new Reply(ReplyTone.NOT_POSSIBLE, text("reply.impossible", text("reason.WORLD")));
        };
        String howFar = text("reply.aborted", progress.amounts(this), progress.place(this));
        return new Reply(why.tone(), why.text() + " " + howFar);
    }

    /** An instruction was refused after {@code done} of {@code of} instructions. */
    Reply refusedAfter(ReplyTone tone, RobotStatus status, int done, int of) {
        Reply refusal = refused(tone, status);
        return done == 0 || tone != ReplyTone.NOT_POSSIBLE
                ? refusal
                : new Reply(tone, refusal.text() + " " + text("reply.partly", "" + done, "" + of));
    }

    Reply stopped(OrderProgress progress) {
        String text = progress.of() == 1
                ? text("reply.stopped", progress.amounts(this))
                : text("reply.stopped.trip", progress.amounts(this), progress.place(this));
        return new Reply(ReplyTone.NOT_POSSIBLE, text);
    }

    /** An order that verification refused. */
    Reply refused(ReplyTone tone, RobotStatus status) {
        return switch (tone) {
            case CONNECTION_DENIED -> denied();
            case EXECUTING -> new Reply(tone, text("reply.executing"));
            default -> new Reply(tone, notPossible(status));
        };
    }

    /** The reply to an order that is not accepted. */
    Reply of(Verdict verdict) {
        if (verdict instanceof Verdict.Invalid invalid) {
            return invalid(invalid.fault());
        }
        return verdict instanceof Verdict.Refused refused
                ? refused(refused.tone(), refused.status())
                : noProcess((Verdict.NoProcess) verdict);
    }

    Reply invalid(OrderFault fault) {
        StringBuilder text =
                new StringBuilder(text("reply.invalid", expected(fault.expected()), "" + fault.position()));
        if (fault.limit() != OrderFault.Limit.NONE) {
            text.append(' ').append(text("limit." + fault.limit()));
        }
        if (fault.timedOut()) {
            text.append(' ').append(text("reply.timeout"));
        }
        return new Reply(ReplyTone.NOT_VALID, text.toString());
    }

    /** An order for a missing process; the reply has the names of the others if they fit, else their numbers. */
    Reply noProcess(Verdict.NoProcess verdict) {
        String number = "" + verdict.order().process().orElseThrow().number();
        String position = "" + verdict.position();
        String all = verdict.processes().entrySet().stream()
                .map(process -> process.getKey() + " " + process.getValue())
                .collect(Collectors.joining(", "));
        String text = text("reply.process.none", number, all.isEmpty() ? "-" : all, position);
        if (text.length() > Reply.MAX_MESSAGE_CHARACTERS - 2) {
            text = text(
                    "reply.process.none",
                    number,
                    ranges(new TreeSet<>(verdict.processes().keySet())),
                    position);
        }
        return new Reply(ReplyTone.NOT_VALID, text);
    }

    /** {@code 1-12, 20}; the first ones if there are too many for a message. */
    private static String ranges(SortedSet<Integer> numbers) {
        StringBuilder ranges = new StringBuilder();
        for (int number : numbers) {
            boolean continues = numbers.contains(number - 1);
            if (!continues && ranges.length() > MOST_RANGES) {
                return ranges + ", ..";
            }
            if (!continues) {
                ranges.append(ranges.isEmpty() ? "" : ", ").append(number);
            } else if (!numbers.contains(number + 1)) {
                ranges.append('-').append(number);
            }
        }
        return ranges.toString();
    }

    Reply processStarted(int number, String name) {
        return new Reply(ReplyTone.EXECUTING, text("reply.process.started", "" + number, name));
    }

    /** A process has ended by itself. @param detail reason of a failure; empty if unknown */
    Reply processEnded(ProcessEnding ending, String name, String detail, RobotStatus status, Pose pose) {
        return switch (ending) {
            case DONE -> new Reply(ReplyTone.EXECUTED, text("reply.done", name, where(status, pose)));
            case COLLISION -> new Reply(ReplyTone.COLLISION, text("reply.process.collision", name));
            case FAILED -> new Reply(ReplyTone.INFINITE_LOOP, processFailed(name, detail));
            case REPLACED -> throw new IllegalArgumentException("a replaced process gets no reply");
        };
    }

    private String processFailed(String name, String detail) {
        String text = text("reply.process.failed", name, detail);
        int most = Reply.MAX_MESSAGE_CHARACTERS - 2;
        return text.length() > most ? text.substring(0, most) : text;
    }

    private Reply denied() {
        return new Reply(ReplyTone.CONNECTION_DENIED, text("reply.denied"));
    }

    private String expected(ExpectedKeys expected) {
        return expected.keys() == null
                ? text("expected." + expected)
                : expected.keys().replace(" / ", text("expected.or"));
    }

    private String notPossible(RobotStatus status) {
        Optional<String> unknown = status == RobotStatus.NO_MOTORS ? unknownType.get() : Optional.empty();
        return text(
                "reply.impossible",
                unknown.map(type -> text("reason.UNKNOWN_TYPE", type)).orElseGet(() -> text("reason." + status)));
    }

    String where(RobotStatus status, Pose pose) {
        return text("reply.where", text("status." + status), pose.xText(3), pose.yText(3), pose.headingText(1));
    }

    String text(String key, String... arguments) {
        return VeriCommandTexts.text(locale, key, arguments);
    }
}
