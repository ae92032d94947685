package simgsm.center.msc.ss;

import simgsm.air.Msisdn;
import simgsm.lesson.StepResult;

/** Receives what phones tell of their users by USSD. */
public interface UserReports {
    /** @param name 1 to 30 characters, no control characters */
    void named(Msisdn number, String name);

    /** A result in a lesson. @return false if the lesson has no such step */
    boolean lessonResult(Msisdn number, StepResult result);
}
