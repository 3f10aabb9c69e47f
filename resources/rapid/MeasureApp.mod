MODULE MeasureApp
  ! Mailbox of MeasureApp: one point-to-point move per order, by joint angles.
  ! Robot Web Services write mm_order, then mm_cmd; this program moves, settles
  ! and sets mm_answer.done. See README.md in this folder. Load it into a motion task;
  ! its main must be the only one of the task.

  RECORD mm_job
    num id;
    jointtarget goal;
    speeddata speed;
  ENDRECORD

  RECORD mm_report
    num run;
    num done;
    num state;
    num error;
    num beat;
  ENDRECORD

  ! Identity: checked by the driver before anything moves. mm_program is the
  ! digest of this file without the line below; README.md says how to renew it.
  PERS string mm_version:="MM 1.0";
  PERS string mm_program:="621b0d752accb01e";
  PERS string mm_owner:="";

  ! Orders, written by the driver. An order runs only if its id equals mm_cmd.
  PERS mm_job mm_order:=[0,[[0,0,0,0,30,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]],[150,30,150,30]];
  PERS num mm_cmd:=0;
  PERS num mm_settle:=0.3;
  PERS bool mm_abort:=FALSE;

  ! Answers, written by this program; one record, so that one reading is one instant.
  PERS mm_report mm_answer:=[0,0,0,0,0];

  ! mm_answer.state
  CONST num mm_idle:=1;
  CONST num mm_moving:=2;
  CONST num mm_settling:=3;
  CONST num mm_refused:=7;
  CONST num mm_aborted:=8;
  CONST num mm_failed:=9;

  VAR mm_job mm_now;
  VAR num mm_seen:=0;
  VAR intnum mm_on_abort;
  VAR intnum mm_on_beat;

  PROC main()
    AccSet 50,50;
    VelSet 100,250;
    mm_abort:=FALSE;
    mm_answer.error:=0;
    ! An order that was written before this start is never run.
    mm_seen:=mm_cmd;
    mm_answer.run:=mm_answer.run+1;
    IDelete mm_on_abort;
    CONNECT mm_on_abort WITH mm_trap_abort;
    IPers mm_abort,mm_on_abort;
    IDelete mm_on_beat;
    CONNECT mm_on_beat WITH mm_trap_beat;
    ITimer 0.2,mm_on_beat;
    mm_answer.state:=mm_idle;
    WHILE TRUE DO
      ! Greater, not different: a write that arrives late must not run again.
      WaitUntil mm_cmd>mm_seen\PollRate:=0.04;
      mm_seen:=mm_cmd;
      mm_now:=mm_order;
      IF mm_now.id<>mm_seen THEN
        mm_answer.state:=mm_refused;
      ELSE
        mm_answer.state:=mm_moving;
        MoveAbsJ mm_now.goal\NoEOffs,mm_now.speed,fine,tool0;
        WaitRob\InPos;
        mm_answer.state:=mm_settling;
        WaitTime mm_settle;
        mm_answer.state:=mm_idle;
        mm_answer.done:=mm_seen;
      ENDIF
    ENDWHILE
  ERROR
    mm_answer.error:=ERRNO;
    mm_answer.state:=mm_failed;
    Stop;
  ENDPROC

  TRAP mm_trap_abort
    IF mm_abort THEN
      StopMove\Quick;
      ClearPath;
      StartMove;
      mm_answer.state:=mm_aborted;
      ! Starts main again: the interrupted move is not continued.
      ExitCycle;
    ENDIF
  ENDTRAP

  TRAP mm_trap_beat
    mm_answer.beat:=mm_answer.beat+1;
    IF mm_answer.beat>1000000 mm_answer.beat:=0;
  ENDTRAP
ENDMODULE
